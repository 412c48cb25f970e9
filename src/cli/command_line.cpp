// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command_line.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QTextStream>
#include <cerrno>
#include <cstdio>

namespace hitscope::cli {

int wrongUsage(const QString& text) {
    QTextStream(stderr) << "hitscope-cli: " << text << "\n"
                        << "Run hitscope-cli --help for what it can do.\n";
    return kWrongUsage;
}

int finish(const Status& status) {
    if (!status) {
        QTextStream(stderr) << "hitscope-cli: " << QString::fromStdString(status.error().message()) << "\n";
        return kFailed;
    }
    return 0;
}

std::optional<int> parse(QCommandLineParser& parser, const QString& command, const QStringList& arguments) {
    if (!parser.parse(arguments)) {
        return wrongUsage(parser.errorText());
    }
    if (parser.isSet(QStringLiteral("help"))) {
        QTextStream(stdout) << helpText(parser, command);
        return 0;
    }
    return std::nullopt;
}

QString helpText(const QCommandLineParser& parser, const QString& command) {
    QString text = parser.helpText();
    const QString program = QCoreApplication::arguments().constFirst();
    if (const qsizetype at = text.indexOf(program); at >= 0) {
        text.replace(at, program.size(), QStringLiteral("hitscope-cli ") + command);
    }
    return text;
}

int flushOutput(int status) {
    errno = 0;
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) {
        return status;
    }
    if (errno == 0) {  // it failed earlier, and the reason is gone: what is cut short gets a line's end
        std::clearerr(stdout);
        std::fputc('\n', stdout);
        std::fflush(stdout);
    }
    const QString why = errno != 0 ? qt_error_string(errno) : QStringLiteral("it is closed or full");
    QTextStream(stderr) << "hitscope-cli: The standard output cannot be written: " << why << ".\n";
    return status == 0 ? kFailed : status;
}

}  // namespace hitscope::cli
