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

QString optionName(const char* name) {
    return QString::fromLatin1(name);
}

QString rangeText(int least, int most) {
    return QStringLiteral("from %1 to %2")
        .arg(grouped(static_cast<qulonglong>(least)), grouped(static_cast<qulonglong>(most)));
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

int takeCount(Invocation& given, const char* name, int least, int most) {
    const std::optional<int> value = parseCount(given.text(name));
    if (!value || *value < least || *value > most) {
        given.complain(
            QStringLiteral("--%1 takes a whole number %2.").arg(optionName(name), rangeText(least, most)));
        return least;
    }
    return *value;
}

std::vector<int> takeCounts(Invocation& given, const char* name, int least, int most) {
    std::vector<int> values;
    for (const QString& part : parts(given.text(name))) {
        const std::optional<int> value = parseCount(part);
        if (!value || *value < least || *value > most) {
            given.complain(
                QStringLiteral("--%1 takes whole numbers %2, separated by commas; \"%3\" is not one.")
                    .arg(optionName(name), rangeText(least, most), part));
            return {least};
        }
        if (std::find(values.begin(), values.end(), *value) == values.end()) {
            values.push_back(*value);
        }
    }
    if (values.empty()) {
        given.complain(QStringLiteral("--%1 takes at least one number.").arg(optionName(name)));
        values.push_back(least);
    }
    return values;
}

Size takeSize(Invocation& given, const char* name) {
    static const QRegularExpression pattern(QStringLiteral("^([0-9]{1,5})[xX]([0-9]{1,5})$"));
    const QRegularExpressionMatch match = pattern.match(given.text(name));
    const Size size{match.captured(1).toInt(), match.captured(2).toInt()};
    const auto fits = [](int side) { return side >= kLeastSide && side <= kMostSide; };
    if (!match.hasMatch() || !fits(size.width) || !fits(size.height)) {
        given.complain(
            QStringLiteral("--%1 takes WIDTHxHEIGHT in pixels, such as 320x180; each from %2 to %3.")
                .arg(optionName(name))
                .arg(kLeastSide)
                .arg(kMostSide));
        return {};
    }
    return size;
}

QStringList takeWords(Invocation& given, const char* name) {
    const UsageOption* option = given.usage().find(optionName(name));
    const QStringList known = option != nullptr ? option->words : QStringList();
    const QStringList values = parts(given.text(name));
    for (const QString& value : values) {
        if (!known.contains(value)) {
            given.complain(QStringLiteral("--%1 does not know \"%2\"; it takes %3.")
                               .arg(optionName(name), value, known.join(QStringLiteral(", "))));
        }
    }
    if (values.isEmpty()) {
        given.complain(QStringLiteral("--%1 takes at least one of %2.")
                           .arg(optionName(name), known.join(QStringLiteral(", "))));
    }
    return values;
}

}  // namespace hitscope::bench
