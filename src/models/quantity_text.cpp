// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/quantity_text.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

namespace hitscope {

namespace {

constexpr int kSignificantDigits = 5;
// So that a column of a panel holds a number: nine characters, the sign among them.
constexpr int kMostDecimals = 6;
constexpr int kExponentDecimals = 2;
constexpr int kLeastMagnitude = -4;
constexpr int kMostMagnitude = 8;

/// The C locale, which bare machines have, leaves group separators out; long vertex counts need them.
QLocale groupingLocale() {
    QLocale locale;
    locale.setNumberOptions(locale.numberOptions() & ~QLocale::OmitGroupSeparator);
    return locale;
}

}  // namespace

QString countText(std::size_t count) {
    return groupingLocale().toString(static_cast<qulonglong>(count));
}

QString quantityText(double value) {
    const QLocale locale = groupingLocale();
    if (value == 0.0 || !std::isfinite(value)) {
        return locale.toString(value, 'g', kSignificantDigits);
    }
    const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(value))));
    if (magnitude < kLeastMagnitude || magnitude > kMostMagnitude) {
        return locale.toString(value, 'e', kExponentDecimals);
    }
    return locale.toString(value, 'f', std::clamp(kSignificantDigits - 1 - magnitude, 0, kMostDecimals));
}

QString vectorText(const glm::vec3& vector) {
    const QLocale locale = groupingLocale();
    const auto number = [&locale](float value) {
        return locale.toString(static_cast<double>(value), 'f', 3);
    };
    return QStringLiteral("%1, %2, %3").arg(number(vector.x), number(vector.y), number(vector.z));
}

}  // namespace hitscope
