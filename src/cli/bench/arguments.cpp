// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/arguments.h"

#include <QRegularExpression>
#include <algorithm>
#include <limits>

#include "cli/bench/report.h"

namespace hitscope::bench {

namespace {

constexpr int kLeastSide = 16;
constexpr int kMostSide = 8192;

QStringList parts(const QString& text) {
    QStringList list = text.split(QLatin1Char(','), Qt::SkipEmptyParts);
    for (QString& part : list) {
        part = part.trimmed();
    }
    list.removeDuplicates();
    return list;
}

}  // namespace

std::optional<int> parseCount(const QString& text) {
    static const QRegularExpression pattern(QStringLiteral("^([0-9]{1,10})([kKmM]?)$"));
    const QRegularExpressionMatch match = pattern.match(text);
    if (!match.hasMatch()) {
        return std::nullopt;
    }
    const QString unit = match.captured(2).toUpper();
    qint64 count = match.captured(1).toLongLong();
    count *= unit == QLatin1String("M") ? 1000000 : unit == QLatin1String("K") ? 1000 : 1;
    return count <= std::numeric_limits<int>::max() ? std::optional(static_cast<int>(count)) : std::nullopt;
}

Arguments::Arguments(const QString& description) {
    m_parser.setApplicationDescription(description);
    m_parser.addHelpOption();
}

void Arguments::addFlag(const QString& name, const QString& help) {
    m_parser.addOption({name, help});
}

void Arguments::addOption(const QString& name, const QString& help, const QString& valueName,
                          const QString& defaultValue) {
    m_parser.addOption({name, help, valueName, defaultValue});
}

void Arguments::parse(QStringList arguments, const QStringList& mayStandAlone) {
    for (qsizetype i = arguments.size() - 1; i >= 0; --i) {
        const bool standsAlone =
            i + 1 == arguments.size() || arguments[i + 1].startsWith(QLatin1String("--"));
        if (standsAlone && mayStandAlone.contains(arguments[i])) {
            arguments.insert(i + 1, QStringLiteral("-"));
        }
    }
    if (!m_parser.parse(arguments)) {
        complain(m_parser.errorText());
    } else if (!m_parser.positionalArguments().isEmpty()) {
        complain(QStringLiteral("\"%1\" is more than it takes.").arg(m_parser.positionalArguments().first()));
    }
}

void Arguments::complain(const QString& sentence) {
    if (m_error.isEmpty()) {
        m_error = sentence;
    }
}

int Arguments::wholeNumber(const QString& name, int least, int most) {
    const std::optional<int> value = parseCount(text(name));
    if (!value || *value < least || *value > most) {
        complain(
            QStringLiteral("--%1 takes a whole number from %2 to %3.")
                .arg(name, grouped(static_cast<qulonglong>(least)), grouped(static_cast<qulonglong>(most))));
        return least;
    }
    return *value;
}

double Arguments::number(const QString& name, double least, double most) {
    bool ok = false;
    const double value = text(name).toDouble(&ok);
    if (!ok || !(value >= least) || !(value <= most)) {
        complain(QStringLiteral("--%1 takes a number from %2 to %3.").arg(name).arg(least).arg(most));
        return least;
    }
    return value;
}

std::vector<int> Arguments::wholeNumbers(const QString& name, int least, int most) {
    std::vector<int> values;
    for (const QString& part : parts(text(name))) {
        const std::optional<int> value = parseCount(part);
        if (!value || *value < least || *value > most) {
            complain(QStringLiteral(
                         "--%1 takes whole numbers from %2 to %3, separated by commas; \"%4\" is not one.")
                         .arg(name, grouped(static_cast<qulonglong>(least)),
                              grouped(static_cast<qulonglong>(most)), part));
            return {least};
        }
        if (std::find(values.begin(), values.end(), *value) == values.end()) {
            values.push_back(*value);
        }
    }
    if (values.empty()) {
        complain(QStringLiteral("--%1 takes at least one number.").arg(name));
        values.push_back(least);
    }
    return values;
}

Arguments::Size Arguments::size(const QString& name) {
    static const QRegularExpression pattern(QStringLiteral("^([0-9]{1,5})[xX]([0-9]{1,5})$"));
    const QRegularExpressionMatch match = pattern.match(text(name));
    const Size size{match.captured(1).toInt(), match.captured(2).toInt()};
    const auto fits = [](int side) { return side >= kLeastSide && side <= kMostSide; };
    if (!match.hasMatch() || !fits(size.width) || !fits(size.height)) {
        complain(QStringLiteral("--%1 takes WIDTHxHEIGHT in pixels, such as 320x180; each from %2 to %3.")
                     .arg(name)
                     .arg(kLeastSide)
                     .arg(kMostSide));
        return {};
    }
    return size;
}

QStringList Arguments::list(const QString& name, const QStringList& known) {
    const QStringList values = parts(text(name));
    for (const QString& value : values) {
        if (!known.isEmpty() && !known.contains(value)) {
            complain(QStringLiteral("--%1 does not know \"%2\"; it takes %3.")
                         .arg(name, value, known.join(QStringLiteral(", "))));
        }
    }
    if (values.isEmpty()) {
        complain(
            QStringLiteral("--%1 takes at least one of %2.").arg(name, known.join(QStringLiteral(", "))));
    }
    return values;
}

}  // namespace hitscope::bench
