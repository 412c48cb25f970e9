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
constexpr int kMostMagnitude = 8;

QString joined(const glm::vec3& vector, const QString& separator, QString (*text)(double)) {
    return text(static_cast<double>(vector.x)) + separator + text(static_cast<double>(vector.y)) + separator +
           text(static_cast<double>(vector.z));
}

}  // namespace

QString countText(std::size_t count) {
    return shownCount(count);
}

QString quantityText(double value) {
    if (value == 0.0 || !std::isfinite(value)) {
        return shownNumber(value, 'g', kSignificantDigits);
    }
    const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(value))));
    if (magnitude < kLeastMagnitude || magnitude > kMostMagnitude) {
        return shownNumber(value, 'e', kExponentDecimals);
    }
    return shownNumber(value, 'f', std::clamp(kSignificantDigits - 1 - magnitude, 0, kMostDecimals));
}

QString vectorText(const glm::vec3& vector) {
    return joined(vector, numberSeparator(), [](double value) { return shownNumber(value, 'f', 3); });
}

QString copiedVectorText(const glm::vec3& vector) {
    return joined(vector, QStringLiteral(", "), [](double value) { return QString::number(value, 'f', 3); });
}

}  // namespace hitscope
