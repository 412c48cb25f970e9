// SPDX-License-Identifier: GPL-3.0-or-later
#include "usage/man_page.h"

namespace hitscope {

namespace {

/// So that roff prints it as it is.
QString escaped(QString text) {
    text.replace(u'\\', QStringLiteral("\\e"));
    text.replace(u'-', QStringLiteral("\\-"));
    text.replace(u'\'', QStringLiteral("\\(aq"));
    if (text.startsWith(u'.')) {
        text.prepend(QStringLiteral("\\&"));
    }
    return text;
}

QString paragraphs(const QString& text) {
    QString made;
    for (const QString& paragraph : text.split(u'\n')) {
        made += QStringLiteral(".PP\n") + escaped(paragraph) + u'\n';
    }
    return made;
}

QString options(const Usage& usage) {
    QString text;
    for (const UsageOption& option : usage.options) {
        text += QStringLiteral(".TP\n\\fB\\-\\-%1\\fR").arg(escaped(option.name));
        if (!option.value.isEmpty()) {
            text += QStringLiteral("=\\fI%1\\fR").arg(escaped(option.value));
        }
        text += u'\n' + escaped(option.fullHelp()) + u'\n';
    }
    return text + QStringLiteral(".TP\n\\fB\\-h\\fR, \\fB\\-\\-help\\fR\nPrint the help.\n");
}

QString examples(const Usage& usage) {
    QString text;
    for (const UsageExample& example : usage.examples) {
        text += QStringLiteral(".PP\n%1\n.PP\n.RS 4\n.EX\n%2\n.EE\n.RE\n")
                    .arg(escaped(example.about), escaped(example.line));
    }
    return text;
}

QString synopsis(const QString& program, const QString& verb, const QString& files, bool hasVerbs = false) {
    return (hasVerbs ? QStringLiteral("\\fB%1\\fR%2%3 [\\fIoptions\\fR]\n")
                     : QStringLiteral("\\fB%1\\fR%2 [\\fIoptions\\fR]%3\n"))
        .arg(escaped(program), verb.isEmpty() ? QString() : QStringLiteral(" \\fB%1\\fR").arg(escaped(verb)),
             files.isEmpty() ? QString() : u' ' + escaped(files));
}

/// Those within a verb come behind it.
template <class Verbs>
QString verbSections(const QString& program, const Verbs& verbs) {
    QString text;
    for (const Usage& verb : verbs) {
        text += QStringLiteral(".SS %1\n").arg(escaped(verb.name));
        text += synopsis(program, verb.name, verb.files, !verb.verbs.empty());
        text += paragraphs(verb.description);
        for (const Usage& within : verb.verbs) {
            text += QStringLiteral(".TP\n\\fB%1\\fR\n%2\n")
                        .arg(escaped(within.lastWord()), escaped(within.about));
        }
        text += options(verb) + examples(verb) + verbSections(program, verb.verbs);
    }
    return text;
}

}  // namespace

QString manPage(const ProgramUsage& program, const QString& version) {
    const QString& name = program.all.name;
    QString text = QStringLiteral(
                       ".\\\" Made of the program's table of options.\n"
                       ".TH %1 1 \"\" \"Hitscope %2\" \"User Commands\"\n"
                       ".SH NAME\n%3 \\- %4\n.SH SYNOPSIS\n")
                       .arg(name.toUpper(), version, escaped(name), escaped(program.all.about));
    if (program.verbs.isEmpty()) {
        text += synopsis(name, {}, program.all.files);
    } else {
        text +=
            QStringLiteral("\\fB%1\\fR \\fIVERB\\fR [\\fIoptions\\fR] [\\fIFILES\\fR]\n").arg(escaped(name));
    }
    text += QStringLiteral(".SH DESCRIPTION\n") + paragraphs(program.all.description) +
            QStringLiteral(".SH OPTIONS\n") + options(program.all);
    if (!program.verbs.isEmpty()) {
        text += QStringLiteral(".SH VERBS\n") + verbSections(name, program.verbs);
    }
    if (!program.all.examples.isEmpty()) {
        text += QStringLiteral(".SH EXAMPLES\n") + examples(program.all);
    }
    text += QStringLiteral(".SH EXIT STATUS\n");
    for (const ExitStatus& status : program.statuses) {
        text += QStringLiteral(".TP\n\\fB%1\\fR\n%2\n").arg(status.number).arg(escaped(status.meaning));
    }
    if (!program.environment.isEmpty()) {
        text += QStringLiteral(".SH ENVIRONMENT\n");
        for (const UsageExample& variable : program.environment) {
            text +=
                QStringLiteral(".TP\n\\fB%1\\fR\n%2\n").arg(escaped(variable.line), escaped(variable.about));
        }
    }
    if (!program.seeAlso.isEmpty()) {
        text += QStringLiteral(".SH SEE ALSO\n%1\n").arg(escaped(program.seeAlso.join(QStringLiteral(", "))));
    }
    return text;
}

}  // namespace hitscope
