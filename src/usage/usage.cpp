// SPDX-License-Identifier: GPL-3.0-or-later
#include "usage/usage.h"

#include <algorithm>

namespace hitscope {

QString UsageOption::fullHelp() const {
    QString text = help;
    if (!words.isEmpty()) {
        text += (takes == Takes::Words ? QStringLiteral(" Of %1; separated by commas.")
                                       : QStringLiteral(" One of %1."))
                    .arg(words.join(QStringLiteral(", ")));
    }
    if (takes == Takes::Words && standard == words.join(u',')) {
        text += QStringLiteral(" Default: all.");
    } else if (!standard.isEmpty()) {
        text += QStringLiteral(" Default: %1.").arg(standard);
    }
    return text;
}

QString UsageOption::synopsis() const {
    return QStringLiteral("--") + name + (value.isEmpty() ? QString() : u'=' + value);
}

UsageOption flagOption(const char* name, const QString& help) {
    return {.name = QString::fromLatin1(name), .help = help, .value = {}, .standard = {}, .words = {}};
}

UsageOption valueOption(const char* name, const char* value, const QString& help, const QString& standard) {
    return {.name = QString::fromLatin1(name),
            .help = help,
            .value = QString::fromLatin1(value),
            .standard = standard,
            .words = {},
            .takes = UsageOption::Takes::Text};
}

UsageOption fileOption(const char* name, const QString& help, const QString& standard) {
    UsageOption option = valueOption(name, "FILE", help, standard);
    option.takes = UsageOption::Takes::File;
    return option;
}

UsageOption outputOption(const char* name, const QString& help) {
    UsageOption option = fileOption(name, help, {});
    option.takes = UsageOption::Takes::Output;
    return option;
}

UsageOption folderOption(const char* name, const QString& help, const QString& standard,
                         const QStringList& writes) {
    UsageOption option = valueOption(name, "FOLDER", help, standard);
    option.takes = UsageOption::Takes::Folder;
    option.writes = writes;
    return option;
}

UsageOption wordOption(const char* name, const char* value, const QStringList& words, const QString& help,
                       const QString& standard) {
    UsageOption option = valueOption(name, value, help, standard);
    option.takes = UsageOption::Takes::Word;
    option.words = words;
    return option;
}

UsageOption wordsOption(const char* name, const QStringList& words, const QString& help,
                        const QString& standard) {
    UsageOption option = valueOption(name, "LIST", help, standard.isEmpty() ? words.join(u',') : standard);
    option.takes = UsageOption::Takes::Words;
    option.words = words;
    return option;
}

const UsageOption* Usage::find(const QString& option) const {
    const auto found = std::find_if(options.begin(), options.end(),
                                    [&option](const UsageOption& each) { return each.name == option; });
    return found == options.end() ? nullptr : &*found;
}

QString Usage::lastWord() const {
    return name.section(u' ', -1);
}

QString Usage::fileName(qsizetype index) const {
    const QStringList names = files.split(u' ');
    return names.value(index, names.constLast()).remove(u'[').remove(u']').remove(QStringLiteral("..."));
}

namespace {

template <class Verbs>
const Usage* findAmong(const Verbs& verbs, const QString& name) {
    for (const Usage& verb : verbs) {
        if (verb.name == name) {
            return &verb;
        }
        if (const Usage* within = findAmong(verb.verbs, name)) {
            return within;
        }
    }
    return nullptr;
}

}  // namespace

const Usage* findVerb(const ProgramUsage& program, const QString& name) {
    return findAmong(program.verbs, name);
}

}  // namespace hitscope
