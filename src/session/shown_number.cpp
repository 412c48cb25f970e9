// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/shown_number.h"

#include <QLocale>

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

QString shownCount(std::size_t count) {
    return groupingLocale().toString(static_cast<qulonglong>(count));
}

QString numberSeparator() {
    return QLocale().decimalPoint() == QLatin1String(",") ? QStringLiteral("; ") : QStringLiteral(", ");
}

}  // namespace hitscope
