// SPDX-License-Identifier: GPL-3.0-or-later
// Help, manual pages and completion, all from the table of options.
#include <QCoreApplication>
#include <QTextStream>

#include "cli/command_line.h"
#include "cli/verbs.h"
#include "usage/completion.h"
#include "usage/help_text.h"
#include "usage/man_page.h"

namespace hitscope::cli {

namespace {

const QStringList& pages() {
    static const QStringList names{QStringLiteral("hitscope-cli"), QStringLiteral("hitscope")};
    return names;
}

int help(Invocation& given) {
    QTextStream out(stdout);
    const auto programOf = [](std::size_t page) -> const ProgramUsage& {
        return page == 0 ? programUsage() : windowUsage();
    };
    const std::size_t page = given.word("program");
    if (given.isSet("completion")) {
        const std::size_t shell = given.word("completion");
        if (!given.error().isEmpty()) {
            return kWrongUsage;
        }
        out << completion(programOf(page), completionShells()[static_cast<qsizetype>(shell)]);
    } else if (given.isSet("man")) {
        out << manPage(programOf(page), QCoreApplication::applicationVersion());
    } else if (given.files().isEmpty()) {
        out << helpText(programUsage());
    } else {
        const QString name = given.files().join(u' ');
        if (const Usage* verb = findVerb(programUsage(), name)) {
            out << helpText(programUsage(), *verb);
            return kGood;
        }
        given.complain(QStringLiteral("there is no verb \"%1\".").arg(name));
    }
    return given.error().isEmpty() ? kGood : kWrongUsage;
}

}  // namespace

Verb helpVerb() {
    return {{.name = QStringLiteral("help"),
             .files = QStringLiteral("[VERB [WHAT]]"),
             .about = QStringLiteral("print help, the manual pages, or completion for a shell"),
             .description =
                 QStringLiteral("Prints the arguments of a verb, the list of verbs, the manual page, or a "
                                "completion script for a shell. One table of options generates them all."),
             .options = {flagOption("man", QStringLiteral("Print the manual page, for man(1).")),
                         wordOption("completion", "SHELL", completionShells(),
                                    QStringLiteral("Print the completion script for this shell.")),
                         wordOption("program", "NAME", pages(),
                                    QStringLiteral("Program whose page or completion to print."),
                                    pages().constFirst())},
             .examples = {{QStringLiteral("Show the arguments of shoot."),
                           QStringLiteral("hitscope-cli help shoot")},
                          {QStringLiteral("Complete command lines in this shell."),
                           QStringLiteral("source <(hitscope-cli help --completion bash)")}},
             .mostFiles = 2,
             .takesVerbs = true},
            help};
}

}  // namespace hitscope::cli
