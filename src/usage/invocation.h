// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCommandLineParser>
#include <QString>
#include <QStringList>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "usage/usage.h"

namespace hitscope {

/// A command line, read by what a Usage says of it. Options are taken out as what they are; the first thing
/// wrong is kept as a sentence that names the option and what it takes. Options that are asked for are in the
/// Usage.
class Invocation {
public:
    /// `arguments`: what follows the program's name and the verb's. `usage` outlives this.
    Invocation(const Usage& usage, const QStringList& arguments);

    [[nodiscard]] const Usage& usage() const { return m_usage; }
    [[nodiscard]] bool wantsHelp() const;
    [[nodiscard]] const QString& error() const { return m_error; }  ///< empty: none
    void complain(const QString& sentence);                         ///< kept where there is none yet

    [[nodiscard]] QStringList files() const { return m_parser.positionalArguments(); }
    [[nodiscard]] QString file(qsizetype index) const { return files().value(index); }  ///< empty: none
    [[nodiscard]] bool isSet(const char* name) const;
    /// The value given last, or the default; empty: neither.
    [[nodiscard]] QString text(const char* name) const;
    [[nodiscard]] QStringList texts(const char* name) const;  ///< of one that is given several times

    // Not a number, or outside the range: an error, and the least is returned.
    [[nodiscard]] int wholeNumber(const char* name, int least, int most);
    [[nodiscard]] double number(const char* name, double least, double most);
    /// Nothing where neither value nor default is there.
    [[nodiscard]] std::optional<double> numberIfSet(const char* name, double least, double most);
    /// Likewise; above 0, and otherwise, or where it is more than the most, an error and 0. `what`: "a length
    /// in metres".
    [[nodiscard]] std::optional<double> positiveIfSet(const char* name, double most, const QString& what);
    [[nodiscard]] std::uint32_t seed(const char* name);  ///< 0 to 4,294,967,295
    /// Which of the option's words; 0, and an error, where it is none.
    [[nodiscard]] std::size_t word(const char* name);

private:
    [[nodiscard]] const UsageOption& optionOf(const char* name) const;
    /// An empty word is a shell's variable that is not set, more often than not: it never means "not given".
    void complainOfEmpty();

    const Usage& m_usage;
    QCommandLineParser m_parser;
    QString m_error;
};

}  // namespace hitscope
