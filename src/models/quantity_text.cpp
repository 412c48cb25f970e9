// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/quantity_text.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

namespace hitscope {

namespace {

constexpr int kSignificantDigits = 5;

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
    if (value == 0.0 || !std::isfinite(value)) {
        return groupingLocale().toString(value, 'g', kSignificantDigits);
    }
    const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(value))));
    if (magnitude < -6 || magnitude > 12) {
        return groupingLocale().toString(value, 'g', kSignificantDigits);
    }
    return groupingLocale().toString(value, 'f', std::clamp(kSignificantDigits - 1 - magnitude, 0, 9));
}

QString vectorText(const glm::vec3& vector) {
    const QLocale locale = groupingLocale();
    const auto number = [&locale](float value) {
        return locale.toString(static_cast<double>(value), 'f', 3);
    };
    return QStringLiteral("%1, %2, %3").arg(number(vector.x), number(vector.y), number(vector.z));
}

}  // namespace hitscope
