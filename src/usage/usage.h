// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>
#include <QStringList>
#include <cstdint>
#include <vector>

namespace hitscope {

/// An option of a command line, described once: parsing, help, manual page and completion go by it.
struct UsageOption {
    /// What a shell proposes for its value.
    enum class Takes : std::uint8_t {
        Nothing,
        Text,
        File,
        Output,  ///< a file that is written
        Folder,
        Word,
        Words
    };

    QString name;       ///< without the two dashes: "seed"
    QString help;       ///< a sentence or more; says nothing of `standard` and `words`
    QString value;      ///< what stands for its value in help: "NUMBER"; empty for a flag
    QString standard;   ///< as one would type it; empty: there is none
    QStringList words;  ///< of Takes::Word, all that may be given; of Takes::Words, separated by commas
    Takes takes = Takes::Nothing;
    QStringList writes{};  ///< of Takes::Folder: the names of files that are written into it

    /// Help, and after it the words and the default.
    [[nodiscard]] QString fullHelp() const;
    /// "--seed=NUMBER", "--json".
    [[nodiscard]] QString synopsis() const;
};

/// One that takes no value.
[[nodiscard]] UsageOption flagOption(const char* name, const QString& help);
/// One that takes a text, most often a number.
[[nodiscard]] UsageOption valueOption(const char* name, const char* value, const QString& help,
                                      const QString& standard = {});
/// One that takes the name of a file to read, of a file to write, or of a folder.
[[nodiscard]] UsageOption fileOption(const char* name, const QString& help, const QString& standard = {});
[[nodiscard]] UsageOption outputOption(const char* name, const QString& help);
/// `writes`: the files that are written into the folder, as far as their names are known beforehand.
[[nodiscard]] UsageOption folderOption(const char* name, const QString& help, const QString& standard = {},
                                       const QStringList& writes = {});
/// One that takes one of some words.
[[nodiscard]] UsageOption wordOption(const char* name, const char* value, const QStringList& words,
                                     const QString& help, const QString& standard = {});
/// One that takes some of these words, separated by commas; all of them by default.
[[nodiscard]] UsageOption wordsOption(const char* name, const QStringList& words, const QString& help,
                                      const QString& standard = {});

/// A command line to learn from.
struct UsageExample {
    QString about;  ///< what it does, a sentence
    QString line;   ///< as one would type it
};

/// What a program, or one verb of it, takes on its command line.
struct Usage {
    QString name;         ///< "shoot", or within another verb "bench frame"; of a program its own name
    QString files;        ///< what follows the options: "[MESH|SESSION]"; empty: nothing may
    QString about;        ///< a line without a full stop, for lists: "shoot at a mesh, print what was hit"
    QString description;  ///< sentences
    QList<UsageOption> options;
    QList<UsageExample> examples;
    int leastFiles = 0;
    int mostFiles = 0;           ///< -1: any number
    int outputFile = -1;         ///< which of them is written; -1: none
    bool takesVerbs = false;     ///< they are no files but the name of a verb, and of one within it
    std::vector<Usage> verbs{};  ///< within this verb; where there are some, one of them follows

    [[nodiscard]] const UsageOption* find(const QString& option) const;  ///< null: there is none
    [[nodiscard]] QString lastWord() const;                              ///< of its name: "frame"
    [[nodiscard]] QString fileName(qsizetype index) const;               ///< of `files`: "MESH|SESSION"
};

/// A number that a program ends with, and when.
struct ExitStatus {
    int number = 0;
    QString meaning;
};

/// A program with verbs ("shoot"), or without.
struct ProgramUsage {
    Usage all;  ///< of the program itself, whatever the verb
    QList<Usage> verbs;
    QList<ExitStatus> statuses;
    QList<UsageExample> environment;  ///< "line": the variable's name
    QStringList seeAlso;              ///< other manual pages: "hitscope(1)"
};

/// The verb of that name ("bench frame"), however deep it is; null: there is none.
[[nodiscard]] const Usage* findVerb(const ProgramUsage& program, const QString& name);

/// The window's program. hitscope-cli makes its manual page as well.
[[nodiscard]] const ProgramUsage& windowUsage();

}  // namespace hitscope
