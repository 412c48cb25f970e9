// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/quantity_text.h"

#include <algorithm>
#include <cmath>

#include "session/shown_number.h"

namespace hitscope {

namespace {

constexpr int kSignificantDigits = 5;
// So that a column of a panel holds a number: nine characters, the sign among them.
constexpr int kMostDecimals = 6;
constexpr int kExponentDecimals = 2;
constexpr int kLeastMagnitude = -4;
constexpr int kMostMagnitude = 6;

constexpr int kUsualDecimals = 3;

/// As QString::number() takes it.
struct Form {
    char format = 'f';
    int decimals = kUsualDecimals;
};

/// One for all three, so that they can be compared; small ones keep three significant digits.
Form formOf(const glm::vec3& vector) {
    const double largest =
        static_cast<double>(std::max({std::abs(vector.x), std::abs(vector.y), std::abs(vector.z)}));
    if (!(largest > 0.0) || !std::isfinite(largest)) {
        return {};
    }
    const int decimals = kUsualDecimals - 1 - static_cast<int>(std::floor(std::log10(largest)));
    return decimals > kMostDecimals ? Form{'e', kExponentDecimals}
                                    : Form{'f', std::max(decimals, kUsualDecimals)};
}

/// What is rounded to nothing has no sign.
double withSign(double value, const Form& form) {
    const double half = form.format == 'f' ? 0.5 * std::pow(10.0, -form.decimals) : 0.0;
    return value == 0.0 || std::abs(value) < half ? 0.0 : value;
}

QString joined(const glm::vec3& vector, const QString& separator, QString (*text)(double, char, int)) {
    const Form form = formOf(vector);
    const auto part = [&](float value) {
        return text(withSign(static_cast<double>(value), form), form.format, form.decimals);
    };
    return part(vector.x) + separator + part(vector.y) + separator + part(vector.z);
}

}  // namespace

QString countText(std::size_t count) {
    return shownCount(count);
}

QString quantityText(double value) {
    return quantityText(shownLocale(), value);
}

QString quantityText(const QLocale& locale, double value) {
    if (value == 0.0 || !std::isfinite(value)) {
        return shownNumber(locale, value == 0.0 ? 0.0 : value, 'g', kSignificantDigits);  // not -0
    }
    const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(value))));
    if (magnitude < kLeastMagnitude || magnitude > kMostMagnitude) {
        return shownNumber(locale, value, 'e', kExponentDecimals);
    }
    return shownNumber(locale, value, 'f', std::clamp(kSignificantDigits - 1 - magnitude, 0, kMostDecimals));
}

QString vectorText(const glm::vec3& vector) {
    return joined(vector, numberSeparator(), [](double value, char format, int decimals) {
        return shownNumber(value, format, decimals);
    });
}

QString copiedVectorText(const glm::vec3& vector) {
    return joined(vector, QStringLiteral(", "), [](double value, char format, int decimals) {
        return QString::number(value, format, decimals);
    });
}

}  // namespace hitscope
