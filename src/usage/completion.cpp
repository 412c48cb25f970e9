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

bool takesFiles(const Usage& usage) {
    return usage.mostFiles != 0 && !usage.takesVerbs;
}

template <class Verbs>
QString lastWords(const Verbs& verbs) {
    QStringList words;
    for (const Usage& verb : verbs) {
        words << verb.lastWord();
    }
    return words.join(u' ');
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

/// Names of files, each a word of its own whatever is in it; -d: of folders. Of quoted ones readline knows
/// more.
QString bashFiles(const ProgramUsage& program, const QString& which) {
    return QStringLiteral("%1_files %2 \"$current\"").arg(functionName(program), which);
}

QString bashFilesFunction(const ProgramUsage& program) {
    return functionName(program) + QStringLiteral(
                                       "_files() {\n"
                                       "    mapfile -t COMPREPLY < <(compgen \"$1\" -- \"$2\")\n"
                                       "    compopt -o filenames 2>/dev/null\n"
                                       "    [[ ${#COMPREPLY[@]} -gt 0 ]] || compopt -o default 2>/dev/null\n"
                                       "}\n");
}

/// A case of `$previous`: what an option's value may be.
QString bashValue(const ProgramUsage& program, const UsageOption& option) {
    QString reply;
    switch (option.takes) {
        case Takes::Word:
            reply = QStringLiteral("COMPREPLY=($(compgen -W \"%1\" -- \"$current\"))")
                        .arg(option.words.join(u' '));
            break;
        case Takes::Words:  // the last of those so far
            reply = QStringLiteral(
                        "COMPREPLY=($(compgen -P \"${current%\"${current##*,}\"}\" -W \"%1\" -- "
                        "\"${current##*,}\")); compopt -o nospace 2>/dev/null")
                        .arg(option.words.join(u' '));
            break;
        case Takes::File:
        case Takes::Output:
            reply = bashFiles(program, QStringLiteral("-f"));
            break;
        case Takes::Folder:
            reply = bashFiles(program, QStringLiteral("-d"));
            break;
        case Takes::Text:
            reply = QStringLiteral("COMPREPLY=()");
            break;
        case Takes::Nothing:
            return {};
    }
    return QStringLiteral("                %1) %2; return ;;\n").arg(dashed(option), reply);
}

QString bashVerb(const ProgramUsage& program, const Usage& usage, const QString& pattern) {
    QString values;
    for (const UsageOption& option : usage.options) {
        values += bashValue(program, option);
    }
    QString text = QStringLiteral("        %1)\n").arg(pattern);
    if (!values.isEmpty()) {
        text +=
            QStringLiteral("            case $previous in\n") + values + QStringLiteral("            esac\n");
    }
    return text + QStringLiteral("            options=\"%1\"%2 ;;\n")
                      .arg(optionNames(usage).join(u' '),
                           takesFiles(usage) ? QString() : QStringLiteral("; files=no"));
}

/// For the word that is the verb, `at` the place it has.
template <class Verbs>
QString bashProposesVerbs(const Verbs& verbs, int at, const QString& condition) {
    return QStringLiteral(
               "    if [[ %1$COMP_CWORD -eq %2 && $current != -* ]]; then\n"
               "        COMPREPLY=($(compgen -W \"%3\" -- \"$current\"))\n"
               "        return\n"
               "    fi\n")
        .arg(condition)
        .arg(at)
        .arg(lastWords(verbs));
}

/// For what `verb` takes: the name of a verb, and of one within it.
QString bashProposesNames(const ProgramUsage& program, const Usage& verb) {
    const QString isIt = QStringLiteral("$verb == %1 && ").arg(verb.name);
    QString text = bashProposesVerbs(program.verbs, 2, isIt);
    for (const Usage& named : program.verbs) {
        if (!named.verbs.empty()) {
            text += bashProposesVerbs(named.verbs, 3,
                                      isIt + QStringLiteral("${COMP_WORDS[2]} == %1 && ").arg(named.name));
        }
    }
    return text;
}

QString bash(const ProgramUsage& program) {
    QString cases;
    QString proposals = QStringLiteral("    local verb=${COMP_WORDS[1]}\n");
    if (!program.verbs.isEmpty()) {
        proposals += bashProposesVerbs(program.verbs, 1, {});
    }
    for (const Usage& verb : program.verbs) {
        cases += bashVerb(program, verb, verb.name);
        if (verb.takesVerbs) {
            proposals += bashProposesNames(program, verb);
        }
        if (verb.verbs.empty()) {
            continue;
        }
        proposals += bashProposesVerbs(verb.verbs, 2, QStringLiteral("$verb == %1 && ").arg(verb.name));
        proposals += QStringLiteral("    [[ $verb == %1 ]] && verb+=\" ${COMP_WORDS[2]}\"\n").arg(verb.name);
        for (const Usage& within : verb.verbs) {
            cases += bashVerb(program, within, u'"' + within.name + u'"');
        }
    }
    cases += bashVerb(program, program.all, QStringLiteral("*"));
    const QString function = functionName(program);
    QString text = QStringLiteral("# Completion for bash, made of the program's table of options.\n") +
                   bashFilesFunction(program) + function +
                   QStringLiteral(
                       "() {\n"
                       "    local current=${COMP_WORDS[COMP_CWORD]} options= files=yes\n"
                       "    local previous=${COMP_WORDS[COMP_CWORD-1]}\n"
                       "    # Readline takes = for a word of its own.\n"
                       "    [[ $current == = ]] && current=\n"
                       "    [[ $previous == = ]] && previous=${COMP_WORDS[COMP_CWORD-2]}\n");
    text += proposals + QStringLiteral("    case $verb in\n") + cases +
            QStringLiteral(
                "    esac\n"
                "    if [[ $current == -* ]]; then\n"
                "        COMPREPLY=($(compgen -W \"$options\" -- \"$current\"))\n"
                "    elif [[ $files == yes ]]; then\n"
                "        %1\n"
                "    fi\n"
                "}\n")
                .arg(bashFiles(program, QStringLiteral("-f")));
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
        case Takes::Words:
            spec +=
                QStringLiteral(":%1:_values -s , %1 %2").arg(option.value.toLower(), option.words.join(u' '));
            break;
        case Takes::File:
        case Takes::Output:
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

/// What a verb takes that takes the name of a verb.
QString zshNames(const ProgramUsage& program) {
    QString text = QStringLiteral(" '1:verb:(%1)'").arg(lastWords(program.verbs));
    QStringList within;
    for (const Usage& verb : program.verbs) {
        if (!verb.verbs.empty()) {
            within << lastWords(verb.verbs);
        }
    }
    return text + QStringLiteral(" '2:what:(%1)'\n").arg(within.join(u' '));
}

QString zshArguments(const ProgramUsage& program, const Usage& usage) {
    QString text = QStringLiteral("_arguments");
    for (const UsageOption& option : usage.options) {
        text += QStringLiteral(" \\\n                ") + zshOption(option);
    }
    text += QStringLiteral(" \\\n                '--help[Print the help]'");
    return text + (usage.takesVerbs    ? zshNames(program)
                   : takesFiles(usage) ? QStringLiteral(" '*:file:_files'\n")
                                       : QStringLiteral("\n"));
}

/// Proposes these, or what the one that is there takes.
template <class Verbs>
QString zshVerbs(const ProgramUsage& program, const Verbs& verbs) {
    QString text = QStringLiteral("    verbs=(\n");
    for (const Usage& verb : verbs) {
        text +=
            QStringLiteral("        %1\n").arg(zshQuoted(verb.lastWord() + u':' + zshEscaped(verb.about)));
    }
    text += QStringLiteral(
        "    )\n    if (( CURRENT == 2 )); then\n        _describe verb verbs\n        return\n"
        "    fi\n    verb=$words[2]\n    shift words\n    (( CURRENT-- ))\n"
        "    case $verb in\n");
    for (const Usage& verb : verbs) {
        text += QStringLiteral("        %1)\n").arg(verb.lastWord()) +
                (verb.verbs.empty() ? QStringLiteral("            ") + zshArguments(program, verb)
                                    : zshVerbs(program, verb.verbs)) +
                QStringLiteral("            ;;\n");
    }
    return text + QStringLiteral("    esac\n");
}

QString zsh(const ProgramUsage& program) {
    QString text =
        QStringLiteral("#compdef %1\n# Completion for zsh, made of the program's table of options.\n")
            .arg(program.all.name);
    if (program.verbs.isEmpty()) {
        return text + zshArguments(program, program.all);
    }
    return text + functionName(program) + QStringLiteral("() {\n    local -a verbs\n    local verb\n") +
           zshVerbs(program, program.verbs) + QStringLiteral("}\n%1 \"$@\"\n").arg(functionName(program));
}

// Fish ---------------------------------------------------------------------------------------------------

QString fishQuoted(QString text) {
    text.replace(u'\\', QStringLiteral("\\\\"));
    text.replace(u'\'', QStringLiteral("\\'"));
    return u'\'' + text + u'\'';
}

QString fishOptions(const ProgramUsage& program, const Usage& usage, const QString& condition) {
    QString text = !takesFiles(usage) && !condition.isEmpty()
                       ? QStringLiteral("complete -c %1%2 -f\n").arg(program.all.name, condition)
                       : QString();
    for (const UsageOption& option : usage.options) {
        text += QStringLiteral("complete -c %1%2 -l %3").arg(program.all.name, condition, option.name);
        switch (option.takes) {
            case Takes::Word:
                text += QStringLiteral(" -x -a %1").arg(fishQuoted(option.words.join(u' ')));
                break;
            case Takes::Words:
                text +=
                    QStringLiteral(" -x -a %1")
                        .arg(fishQuoted(QStringLiteral("(__fish_complete_list , 'string split \" \" \"%1\"')")
                                            .arg(option.words.join(u' '))));
                break;
            case Takes::Folder:
                text += QStringLiteral(" -x -a '(__fish_complete_directories)'");
                break;
            case Takes::File:
            case Takes::Output:
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

/// A function of fish that says whether the words behind the program begin with its arguments, and one that
/// says whether they are these and no more.
QString fishFunctions(const QString& name) {
    return QStringLiteral(
               "function %1_begins\n"
               "    set -l words (commandline -opc)\n"
               "    set -e words[1]\n"
               "    test (count $words) -ge (count $argv); or return 1\n"
               "    for i in (seq (count $argv))\n"
               "        test $words[$i] = $argv[$i]; or return 1\n"
               "    end\n"
               "end\n"
               "function %1_is\n"
               "    test (count (commandline -opc)) -eq (math 1 + (count $argv)); and %1_begins $argv\n"
               "end\n")
        .arg(name);
}

/// For what `verb` takes: the name of a verb, and of one within it.
QString fishNames(const ProgramUsage& program, const Usage& verb) {
    const auto line = [&](const QString& words, const QString& names) {
        return QStringLiteral("complete -c %1 -f -n '_%2_is %3' -a %4\n")
            .arg(program.all.name, functionName(program), words, fishQuoted(names));
    };
    QString text = line(verb.name, lastWords(program.verbs));
    for (const Usage& named : program.verbs) {
        if (!named.verbs.empty()) {
            text += line(verb.name + u' ' + named.name, lastWords(named.verbs));
        }
    }
    return text;
}

/// Proposes these where `condition` holds, and what each of them takes.
template <class Verbs>
QString fishVerbs(const ProgramUsage& program, const Verbs& verbs, const QString& condition) {
    QString text;
    for (const Usage& verb : verbs) {
        text += QStringLiteral("complete -c %1 -f -n %2 -a %3 -d %4\n")
                    .arg(program.all.name, fishQuoted(condition), verb.lastWord(), fishQuoted(verb.about));
    }
    for (const Usage& verb : verbs) {
        text += verb.takesVerbs ? fishNames(program, verb) : QString();
        text += verb.verbs.empty()
                    ? fishOptions(program, verb,
                                  QStringLiteral(" -n '_%1_begins %2'").arg(functionName(program), verb.name))
                    : fishVerbs(program, verb.verbs,
                                QStringLiteral("_%1_is %2").arg(functionName(program), verb.name));
    }
    return text;
}

QString fish(const ProgramUsage& program) {
    QString text = QStringLiteral("# Completion for fish, made of the program's table of options.\n");
    if (program.verbs.isEmpty()) {
        return text + fishOptions(program, program.all, {});
    }
    const QString alone = u'_' + functionName(program) + QStringLiteral("_is");
    return text + fishFunctions(u'_' + functionName(program)) + fishVerbs(program, program.verbs, alone) +
           fishOptions(program, program.all, QStringLiteral(" -n %1").arg(alone));
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
