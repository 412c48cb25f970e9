// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/shown_number.h"

#include <QLocale>
#include <charconv>
#include <cmath>
#include <string>

#include "io/number_text.h"

namespace hitscope {

namespace {

/// The C locale, which bare machines have, leaves group separators out; long vertex counts need them.
QLocale groupingLocale() {
    QLocale locale;
    locale.setNumberOptions(locale.numberOptions() & ~QLocale::OmitGroupSeparator);
    return locale;
}

}  // namespace

QString shownNumber(double value, char format, int precision) {
    return groupingLocale().toString(value, format, precision);
}

QString shownFloat(float value) {
    constexpr double kLeastPlain = 1.0e-5;
    constexpr double kMostPlain = 1.0e7;
    std::string digits;
    appendNumber(digits, value);
    double number = 0.0;
    std::from_chars(digits.data(), digits.data() + digits.size(), number);
    const double size = std::abs(number);
    const bool isPlain =
        number == 0.0 || !std::isfinite(number) || (size >= kLeastPlain && size < kMostPlain);
    QLocale locale;
    locale.setNumberOptions(locale.numberOptions() | QLocale::OmitGroupSeparator);
    return locale.toString(number, isPlain ? 'f' : 'e', QLocale::FloatingPointShortest);
}

QString shownCount(std::size_t count) {
    return groupingLocale().toString(static_cast<qulonglong>(count));
}

QString numberSeparator() {
    return QLocale().decimalPoint() == QLatin1String(",") ? QStringLiteral("; ") : QStringLiteral(", ");
}

}  // namespace hitscope
