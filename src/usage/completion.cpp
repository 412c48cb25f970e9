// SPDX-License-Identifier: GPL-3.0-or-later
#include "usage/completion.h"

namespace hitscope {

namespace {

using Takes = UsageOption::Takes;

QString dashed(const UsageOption& option) {
    return QStringLiteral("--") + option.name;
}

QStringList optionNames(const Usage& usage) {
    QStringList names;
    for (const UsageOption& option : usage.options) {
        names << dashed(option);
    }
    return names << QStringLiteral("--help");
}

QString functionName(const ProgramUsage& program) {
    QString name = program.all.name;
    return u'_' + name.replace(u'-', u'_');
}

/// The first sentence, which is enough beside a proposal.
QString firstSentence(const QString& help) {
    const qsizetype end = help.indexOf(QStringLiteral(". "));
    QString sentence = end < 0 ? help : help.left(end + 1);
    if (sentence.endsWith(u'.')) {
        sentence.chop(1);
    }
    return sentence;
}

// Bash ---------------------------------------------------------------------------------------------------

/// A case of `$previous`: what an option's value may be.
QString bashValue(const UsageOption& option) {
    QString reply;
    switch (option.takes) {
        case Takes::Word:
            reply = QStringLiteral("COMPREPLY=($(compgen -W \"%1\" -- \"$current\"))")
                        .arg(option.words.join(u' '));
            break;
        case Takes::File:
            reply = QStringLiteral("COMPREPLY=($(compgen -f -- \"$current\"))");
            break;
        case Takes::Folder:
            reply = QStringLiteral("COMPREPLY=($(compgen -d -- \"$current\"))");
            break;
        case Takes::Text:
            reply = QStringLiteral("COMPREPLY=()");
            break;
        case Takes::Nothing:
            return {};
    }
    return QStringLiteral("                %1) %2; return ;;\n").arg(dashed(option), reply);
}

QString bashVerb(const Usage& usage, const QString& pattern) {
    QString values;
    for (const UsageOption& option : usage.options) {
        values += bashValue(option);
    }
    QString text = QStringLiteral("        %1)\n").arg(pattern);
    if (!values.isEmpty()) {
        text +=
            QStringLiteral("            case $previous in\n") + values + QStringLiteral("            esac\n");
    }
    return text + QStringLiteral("            options=\"%1\" ;;\n").arg(optionNames(usage).join(u' '));
}

QString bash(const ProgramUsage& program) {
    QStringList verbs;
    QString cases;
    for (const Usage& verb : program.verbs) {
        verbs << verb.name;
        cases += bashVerb(verb, verb.name);
    }
    cases += bashVerb(program.all, QStringLiteral("*"));
    const QString function = functionName(program);
    QString text = QStringLiteral("# Completion for bash, made of the program's table of options.\n") +
                   function +
                   QStringLiteral(
                       "() {\n"
                       "    local current=${COMP_WORDS[COMP_CWORD]} options=\n"
                       "    local previous=${COMP_WORDS[COMP_CWORD-1]}\n"
                       "    # Readline takes = for a word of its own.\n"
                       "    [[ $current == = ]] && current=\n"
                       "    [[ $previous == = ]] && previous=${COMP_WORDS[COMP_CWORD-2]}\n"
                       "    compopt -o filenames 2>/dev/null\n");
    if (!verbs.isEmpty()) {
        text += QStringLiteral(
                    "    if [[ $COMP_CWORD -eq 1 && $current != -* ]]; then\n"
                    "        COMPREPLY=($(compgen -W \"%1\" -- \"$current\"))\n"
                    "        return\n"
                    "    fi\n")
                    .arg(verbs.join(u' '));
    }
    text += QStringLiteral("    case ${COMP_WORDS[1]} in\n") + cases +
            QStringLiteral(
                "    esac\n"
                "    if [[ $current == -* ]]; then\n"
                "        COMPREPLY=($(compgen -W \"$options\" -- \"$current\"))\n"
                "    else\n"
                "        COMPREPLY=($(compgen -f -- \"$current\"))\n"
                "    fi\n"
                "}\n");
    return text + QStringLiteral("complete -F %1 %2\n").arg(function, program.all.name);
}

// Zsh ----------------------------------------------------------------------------------------------------

QString zshQuoted(QString text) {
    text.replace(u'\'', QStringLiteral("'\\''"));
    return u'\'' + text + u'\'';
}

/// Within an optspec, brackets and colons have a meaning.
QString zshEscaped(QString text) {
    for (const QChar special : {u'\\', u'[', u']', u':'}) {
        text.replace(special, QStringLiteral("\\") + special);
    }
    return text;
}

QString zshOption(const UsageOption& option) {
    QString spec = dashed(option);
    if (option.takes != Takes::Nothing) {
        spec += u'=';
    }
    spec += u'[' + zshEscaped(firstSentence(option.help)) + u']';
    switch (option.takes) {
        case Takes::Word:
            spec += QStringLiteral(":%1:(%2)").arg(option.value.toLower(), option.words.join(u' '));
            break;
        case Takes::File:
            spec += QStringLiteral(":file:_files");
            break;
        case Takes::Folder:
            spec += QStringLiteral(":folder:_files -/");
            break;
        case Takes::Text:
            spec += QStringLiteral(":%1: ").arg(zshEscaped(option.value.toLower()));
            break;
        case Takes::Nothing:
            break;
    }
    return zshQuoted(spec);
}

QString zshArguments(const Usage& usage) {
    QString text = QStringLiteral("_arguments");
    for (const UsageOption& option : usage.options) {
        text += QStringLiteral(" \\\n                ") + zshOption(option);
    }
    return text + QStringLiteral(" \\\n                '--help[Print the help]' '*:file:_files'\n");
}

QString zsh(const ProgramUsage& program) {
    QString text =
        QStringLiteral("#compdef %1\n# Completion for zsh, made of the program's table of options.\n")
            .arg(program.all.name);
    if (program.verbs.isEmpty()) {
        return text + zshArguments(program.all);
    }
    text += functionName(program) + QStringLiteral("() {\n    local -a verbs=(\n");
    for (const Usage& verb : program.verbs) {
        text += QStringLiteral("        %1\n").arg(zshQuoted(verb.name + u':' + zshEscaped(verb.about)));
    }
    text += QStringLiteral(
        "    )\n    if (( CURRENT == 2 )); then\n        _describe verb verbs\n        return\n"
        "    fi\n    local verb=$words[2]\n    shift words\n    (( CURRENT-- ))\n"
        "    case $verb in\n");
    for (const Usage& verb : program.verbs) {
        text +=
            QStringLiteral("        %1)\n            %2            ;;\n").arg(verb.name, zshArguments(verb));
    }
    return text + QStringLiteral("    esac\n}\n%1 \"$@\"\n").arg(functionName(program));
}

// Fish ---------------------------------------------------------------------------------------------------

QString fishQuoted(QString text) {
    text.replace(u'\\', QStringLiteral("\\\\"));
    text.replace(u'\'', QStringLiteral("\\'"));
    return u'\'' + text + u'\'';
}

QString fishOptions(const ProgramUsage& program, const Usage& usage, const QString& condition) {
    QString text;
    for (const UsageOption& option : usage.options) {
        text += QStringLiteral("complete -c %1%2 -l %3").arg(program.all.name, condition, option.name);
        switch (option.takes) {
            case Takes::Word:
                text += QStringLiteral(" -x -a %1").arg(fishQuoted(option.words.join(u' ')));
                break;
            case Takes::Folder:
                text += QStringLiteral(" -x -a '(__fish_complete_directories)'");
                break;
            case Takes::File:
                text += QStringLiteral(" -r -F");
                break;
            case Takes::Text:
                text += QStringLiteral(" -x");
                break;
            case Takes::Nothing:
                break;
        }
        text += QStringLiteral(" -d %1\n").arg(fishQuoted(firstSentence(option.help)));
    }
    return text;
}

QString fish(const ProgramUsage& program) {
    QString text = QStringLiteral("# Completion for fish, made of the program's table of options.\n");
    for (const Usage& verb : program.verbs) {
        text += QStringLiteral("complete -c %1 -f -n __fish_use_subcommand -a %2 -d %3\n")
                    .arg(program.all.name, verb.name, fishQuoted(verb.about));
    }
    for (const Usage& verb : program.verbs) {
        text +=
            fishOptions(program, verb, QStringLiteral(" -n '__fish_seen_subcommand_from %1'").arg(verb.name));
    }
    return text +
           fishOptions(program, program.all,
                       program.verbs.isEmpty() ? QString() : QStringLiteral(" -n __fish_use_subcommand"));
}

}  // namespace

const QStringList& completionShells() {
    static const QStringList shells{QStringLiteral("bash"), QStringLiteral("zsh"), QStringLiteral("fish")};
    return shells;
}

QString completion(const ProgramUsage& program, const QString& shell) {
    return shell == completionShells()[0]   ? bash(program)
           : shell == completionShells()[1] ? zsh(program)
                                            : fish(program);
}

}  // namespace hitscope
