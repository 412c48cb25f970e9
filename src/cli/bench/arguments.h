// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCommandLineParser>
#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "cli/command_line.h"

namespace hitscope::bench {

/// The options of one benchmark: declared, parsed, and taken out as what they are. The first thing wrong is
/// kept as a sentence that names the option and what it takes.
class Arguments {
public:
    explicit Arguments(const QString& description);

    void addFlag(const QString& name, const QString& help);
    void addOption(const QString& name, const QString& help, const QString& valueName,
                   const QString& defaultValue = {});

    /// `arguments` as the program has them, its name first. Options named in `mayStandAlone` need no value;
    /// they then have "-".
    void parse(QStringList arguments, const QStringList& mayStandAlone = {});
    [[nodiscard]] bool wantsHelp() const { return m_parser.isSet(QStringLiteral("help")); }
    /// `benchmark`: "frame"
    [[nodiscard]] QString help(const QString& benchmark) const {
        return cli::helpText(m_parser, QStringLiteral("bench ") + benchmark);
    }
    [[nodiscard]] const QString& error() const { return m_error; }  ///< empty: none

    [[nodiscard]] bool isSet(const QString& name) const { return m_parser.isSet(name); }
    [[nodiscard]] QString text(const QString& name) const { return m_parser.value(name); }
    // Outside the range, or not a number: an error, and the least is returned.
    [[nodiscard]] int wholeNumber(const QString& name, int least, int most);
    [[nodiscard]] double number(const QString& name, double least, double most);
    /// "8K,1M,250": whole numbers from least to most, in the order given, each once; K is a thousand, M a
    /// million.
    [[nodiscard]] std::vector<int> wholeNumbers(const QString& name, int least, int most);
    /// "320x180", each side from 16 to 8192.
    struct Size {
        int width = 16;
        int height = 16;
    };
    [[nodiscard]] Size size(const QString& name);
    /// Values separated by commas, each once, each of `known` (any, where that is empty).
    [[nodiscard]] QStringList list(const QString& name, const QStringList& known);

private:
    void complain(const QString& sentence);

    QCommandLineParser m_parser;
    QString m_error;
};

/// "8K" is 8000, "10M" 10,000,000, "250" 250; nothing if it is none of these or does not fit an int.
[[nodiscard]] std::optional<int> parseCount(const QString& text);

}  // namespace hitscope::bench
