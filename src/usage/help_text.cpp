// SPDX-License-Identifier: GPL-3.0-or-later
#include "usage/help_text.h"

#include <algorithm>

namespace hitscope {

namespace {

constexpr qsizetype kWidth = 80;
constexpr qsizetype kWidestName = 24;

/// In lines of kWidth, each `indent` spaces in; the first begins at `column`.
QString wrapped(const QString& text, qsizetype indent, qsizetype column) {
    QString lines;
    const QStringList words = text.split(u' ', Qt::SkipEmptyParts);
    bool isFirst = true;
    for (const QString& word : words) {
        if (!isFirst && column + 1 + word.size() > kWidth) {
            lines += u'\n' + QString(indent, u' ');
            column = indent;
        } else if (!isFirst) {
            lines += u' ';
            ++column;
        }
        lines += word;
        column += word.size();
        isFirst = false;
    }
    return lines + u'\n';
}

/// Name on the left, what it is on the right.
QString row(const QString& name, const QString& about, qsizetype width) {
    const QString left = QStringLiteral("  ") + name;
    const qsizetype indent = width + 4;
    QString text = left;
    if (left.size() + 2 > indent) {
        text += u'\n' + QString(indent, u' ');
    } else {
        text += QString(indent - left.size(), u' ');
    }
    return text + wrapped(about, indent, indent);
}

QString optionRows(const Usage& usage) {
    const QString help = QStringLiteral("--help");
    qsizetype width = help.size();
    for (const UsageOption& option : usage.options) {
        if (option.synopsis().size() <= kWidestName) {
            width = std::max(width, option.synopsis().size());
        }
    }
    QString text;
    for (const UsageOption& option : usage.options) {
        text += row(option.synopsis(), option.fullHelp(), width);
    }
    return text + row(help, QStringLiteral("Print this help."), width);
}

/// A verb a line.
template <class Verbs>
QString verbRows(const Verbs& verbs) {
    qsizetype width = 0;
    for (const Usage& verb : verbs) {
        width = std::max(width, verb.lastWord().size());
    }
    QString text;
    for (const Usage& verb : verbs) {
        text += row(verb.lastWord(), verb.about, width);
    }
    return text;
}

QString exampleRows(const Usage& usage) {
    QString text;
    for (const UsageExample& example : usage.examples) {
        text += QStringLiteral("  %1\n      %2").arg(example.line, wrapped(example.about, 6, 6));
    }
    return text;
}

QString statusRows(const ProgramUsage& program) {
    QString text;
    constexpr qsizetype kDigits = 3;
    for (const ExitStatus& status : program.statuses) {
        text += row(QString::number(status.number), status.meaning, kDigits);
    }
    return text;
}

}  // namespace

QString helpText(const ProgramUsage& program, const Usage& verb) {
    const bool isProgram = &verb == &program.all;
    const QString files = verb.files.isEmpty() ? QString() : u' ' + verb.files;
    QString text = (verb.verbs.empty() ? QStringLiteral("Usage: %1%2 [options]%3\n\n")
                                       : QStringLiteral("Usage: %1%2%3 [options]\n\n"))
                       .arg(program.all.name, isProgram ? QString() : u' ' + verb.name, files);
    for (const QString& paragraph : verb.description.split(QStringLiteral("\n"))) {
        text += wrapped(paragraph, 0, 0);
    }
    if (!verb.verbs.empty()) {
        text += QStringLiteral("\n%1:\n").arg(verb.files) + verbRows(verb.verbs);
    }
    text += QStringLiteral("\nOptions:\n") + optionRows(verb);
    if (!verb.examples.isEmpty()) {
        text += QStringLiteral("\nExamples:\n") + exampleRows(verb);
    }
    text += QStringLiteral("\nExit status:\n") + statusRows(program);
    return verb.verbs.empty()
               ? text
               : text + QStringLiteral("\nRun %1 %2 %3 --help for the options of each, with examples.\n")
                            .arg(program.all.name, verb.name, verb.files);
}

QString helpText(const ProgramUsage& program) {
    QString text = QStringLiteral("Usage: %1 VERB [options] [FILES]\n\n").arg(program.all.name);
    text += wrapped(program.all.description, 0, 0) + QStringLiteral("\nVerbs:\n") + verbRows(program.verbs);
    text += QStringLiteral("\nOptions:\n") + optionRows(program.all) + QStringLiteral("\nExit status:\n") +
            statusRows(program);
    return text + QStringLiteral("\nRun %1 VERB --help for the options of a verb, with examples.\n")
                      .arg(program.all.name);
}

}  // namespace hitscope
