// SPDX-License-Identifier: GPL-3.0-or-later
#include "usage/invocation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace hitscope {

namespace {

QString named(const char* name) {
    return QString::fromLatin1(name);
}

QString countText(int count) {
    return count == 1 ? QStringLiteral("one file") : QStringLiteral("%1 files").arg(count);
}

/// "shoot takes one file at most."
QString wrongCount(const Usage& usage, qsizetype count) {
    const bool tooFew = count < usage.leastFiles;
    const int limit = tooFew ? usage.leastFiles : usage.mostFiles;
    if (limit == 0) {
        return QStringLiteral("%1 takes no files.").arg(usage.name);
    }
    return QStringLiteral("%1 takes %2%3: %4.")
        .arg(usage.name, countText(limit),
             usage.leastFiles == usage.mostFiles ? QString()
             : tooFew                            ? QStringLiteral(" at least")
                                                 : QStringLiteral(" at most"),
             usage.files);
}

QString orLeaveOut(bool isOptional) {
    return isOptional ? QStringLiteral(" or leave it out") : QString();
}

/// How many letters have to be typed, left out or replaced (Levenshtein's distance).
int lettersApart(const QString& a, const QString& b) {
    std::vector<int> row(static_cast<std::size_t>(b.size()) + 1);
    std::iota(row.begin(), row.end(), 0);
    for (qsizetype i = 0; i < a.size(); ++i) {
        int before = std::exchange(row[0], static_cast<int>(i) + 1);
        for (std::size_t j = 1; j < row.size(); ++j) {
            const int replaced = before + (a[i] == b[static_cast<qsizetype>(j) - 1] ? 0 : 1);
            before = row[j];
            row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row.back();
}

/// " Did you mean --random?", where an option that is not known is like one that is; else empty.
QString suggestion(const Usage& usage, const QStringList& arguments) {
    constexpr int kAlike = 2;
    for (const QString& argument : arguments) {
        const QString name =
            argument.section(u'=', 0, 0).mid(argument.startsWith(QLatin1String("--")) ? 2 : 1);
        if (argument == QLatin1String("--")) {
            break;
        }
        const bool isLong = argument.startsWith(QLatin1String("--"));
        if (!argument.startsWith(u'-') || name.size() < 2 || (isLong && usage.find(name) != nullptr)) {
            continue;
        }
        const UsageOption* nearest = nullptr;
        int least = std::min<int>(kAlike, static_cast<int>(name.size()) / 2) + 1;
        for (const UsageOption& option : usage.options) {
            if (const int apart = lettersApart(name, option.name); apart < least) {
                least = apart;
                nearest = &option;
            }
        }
        if (nearest != nullptr) {
            return QStringLiteral(" Did you mean --%1?").arg(nearest->name);
        }
    }
    return {};
}

}  // namespace

Invocation::Invocation(const Usage& usage, const QStringList& arguments) : m_usage(usage) {
    m_parser.addHelpOption();
    for (const UsageOption& option : usage.options) {
        QCommandLineOption made(option.name);
        made.setValueName(option.value);
        if (!option.standard.isEmpty()) {
            made.setDefaultValue(option.standard);
        }
        m_parser.addOption(made);
    }
    if (!m_parser.parse(QStringList{usage.name} + arguments)) {
        complain(m_parser.errorText() + suggestion(usage, arguments));
        return;
    }
    const qsizetype count = files().size();
    if (!wantsHelp() && (count < usage.leastFiles || (usage.mostFiles >= 0 && count > usage.mostFiles))) {
        complain(wrongCount(usage, count));
    }
    if (!wantsHelp()) {
        complainOfEmpty();
    }
}

void Invocation::complainOfEmpty() {
    for (const UsageOption& option : m_usage.options) {
        if (option.takes != UsageOption::Takes::Nothing && m_parser.values(option.name).contains(QString()) &&
            m_parser.isSet(option.name)) {
            complain(QStringLiteral("--%1 is empty; give it a value%2.").arg(option.name, orLeaveOut(true)));
        }
    }
    for (qsizetype i = 0; i < files().size(); ++i) {
        if (file(i).isEmpty()) {
            complain(QStringLiteral("the argument %1 of %2 is empty; give it a value%3.")
                         .arg(m_usage.fileName(i), m_usage.name, orLeaveOut(i >= m_usage.leastFiles)));
        }
    }
}

bool Invocation::wantsHelp() const {
    return m_parser.isSet(QStringLiteral("help"));
}

void Invocation::complain(const QString& sentence) {
    if (m_error.isEmpty()) {
        m_error = sentence;
    }
}

const UsageOption& Invocation::optionOf(const char* name) const {
    const UsageOption* option = m_usage.find(named(name));
    if (option == nullptr) {
        qFatal("%s has no option --%s", qPrintable(m_usage.name), name);
    }
    return *option;
}

bool Invocation::isSet(const char* name) const {
    return m_parser.isSet(optionOf(name).name);
}

QString Invocation::text(const char* name) const {
    const UsageOption& option = optionOf(name);
    return option.takes == UsageOption::Takes::Nothing ? QString() : m_parser.value(option.name);  // Qt warns
}

QStringList Invocation::texts(const char* name) const {
    const UsageOption& option = optionOf(name);
    return option.takes == UsageOption::Takes::Nothing ? QStringList() : m_parser.values(option.name);
}

int Invocation::wholeNumber(const char* name, int least, int most) {
    bool isNumber = false;
    const int value = text(name).toInt(&isNumber);
    if (!isNumber || value < least || value > most) {
        complain(
            QStringLiteral("--%1 takes a whole number from %2 to %3.").arg(named(name)).arg(least).arg(most));
        return least;
    }
    return value;
}

double Invocation::number(const char* name, double least, double most) {
    bool isNumber = false;
    const double value = text(name).toDouble(&isNumber);
    if (!isNumber || !(value >= least && value <= most)) {
        complain(QStringLiteral("--%1 takes a number from %2 to %3.").arg(named(name)).arg(least).arg(most));
        return least;
    }
    return value;
}

std::optional<double> Invocation::numberIfSet(const char* name, double least, double most) {
    return text(name).isEmpty() && !isSet(name) ? std::nullopt : std::optional(number(name, least, most));
}

std::optional<double> Invocation::positiveIfSet(const char* name, double most, const QString& what) {
    if (!isSet(name)) {
        return std::nullopt;
    }
    bool isNumber = false;
    const double value = text(name).toDouble(&isNumber);
    if (!isNumber || !(static_cast<float>(value) > 0.0f && value <= most)) {
        complain(QStringLiteral("--%1 takes %2 above 0, %3 at most.").arg(named(name), what).arg(most));
        return 0.0;
    }
    return value;
}

std::uint32_t Invocation::seed(const char* name) {
    bool isNumber = false;
    const uint value = text(name).toUInt(&isNumber);
    if (!isNumber) {
        complain(QStringLiteral("--%1 takes a whole number from 0 to 4294967295.").arg(named(name)));
    }
    return isNumber ? value : 0;
}

std::size_t Invocation::word(const char* name) {
    const UsageOption& option = optionOf(name);
    const qsizetype place = option.words.indexOf(text(name));
    if (place < 0) {
        complain(QStringLiteral("--%1 takes one of %2.")
                     .arg(option.name, option.words.join(QStringLiteral(", "))));
    }
    return static_cast<std::size_t>(std::max<qsizetype>(place, 0));
}

}  // namespace hitscope
