// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/shown_number.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <QTranslator>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>

#include "io/number_text.h"

namespace hitscope {

namespace {

constexpr double kMostPlain = 1.0e7;  // larger numbers are shown with powers of ten

/// The C locale, which bare machines have, leaves group separators out; long vertex counts need them.
QLocale grouping(QLocale locale) {
    locale.setNumberOptions(locale.numberOptions() & ~QLocale::OmitGroupSeparator);
    return locale;
}

/// Any translation that is installed later is asked before it.
class EnglishPlurals : public QTranslator {
public:
    using QTranslator::QTranslator;
    QString translate(const char*, const char* text, const char*, int number) const override {
        return number < 0 ? QString() : inEnglish(QString::fromUtf8(text), number);
    }
};

void installEnglishPlurals() {
    QCoreApplication::installTranslator(new EnglishPlurals(QCoreApplication::instance()));
}
Q_COREAPP_STARTUP_FUNCTION(installEnglishPlurals)

}  // namespace

QString inEnglish(const QString& text, int number) {
    static const QRegularExpression kForms(QStringLiteral("\\{([^{}|]*)\\|([^{}|]*)\\}"));
    return QString(text)
        .replace(kForms, number == 1 ? QStringLiteral("\\1") : QStringLiteral("\\2"))
        .replace(QStringLiteral("%Ln"), shownCount(static_cast<std::size_t>(number)));
}

int trCount(std::size_t count) {
    return static_cast<int>(std::min(count, std::size_t{std::numeric_limits<int>::max()}));
}

QLocale shownLocale() {
    return grouping(QLocale());
}

QLocale copiedLocale() {
    return grouping(QLocale::c());
}

QString shownNumber(double value, char format, int precision) {
    return shownNumber(shownLocale(), value, format, precision);
}

QString shownNumber(const QLocale& locale, double value, char format, int precision) {
    if (format == 'g' && precision > 0) {
        // A thousand metres are no reason for powers of ten.
        const double step = std::pow(10.0, std::floor(std::log10(std::abs(value))) - (precision - 1));
        const double rounded = std::round(value / step) * step;
        if (std::abs(rounded) >= std::pow(10.0, precision) && std::abs(rounded) < kMostPlain) {
            return locale.toString(rounded, 'f', 0);
        }
    }
    return locale.toString(value, format, precision);
}

QString shownFloat(float value) {
    constexpr double kLeastPlain = 1.0e-5;
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
    return shownLocale().toString(static_cast<qulonglong>(count));
}

QString numberSeparator() {
    return QLocale().decimalPoint() == QLatin1String(",") ? QStringLiteral("; ") : QStringLiteral(", ");
}

}  // namespace hitscope
