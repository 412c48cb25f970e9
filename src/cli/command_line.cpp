// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command_line.h"

#include <QCoreApplication>
#include <QTextStream>
#include <cerrno>
#include <csignal>
#include <cstdio>

#include "cli/progress_line.h"

namespace hitscope::cli {

namespace {

bool quietSoFar = false;

}  // namespace

int wrongUsage(const QString& text, const QString& verb) {
    QTextStream(stderr) << "hitscope-cli: " << text << "\n"
                        << "Run hitscope-cli " << (verb.isEmpty() ? QString() : verb + u' ')
                        << "--help for what it can do.\n";
    return kWrongUsage;
}

int finish(const Outcome& outcome) {
    if (!outcome) {
        WaitingLine::hide();
        QTextStream(stderr) << "hitscope-cli: " << QString::fromStdString(outcome.error().message()) << "\n";
    }
    return outcome.status();
}

QString counted(std::size_t count, const char* one, const char* many) {
    return QString::number(count) + u' ' + QString::fromLatin1(count == 1 ? one : many);
}

void note(const QString& text) {
    if (!quietSoFar) {
        WaitingLine::hide();
        QTextStream(stderr) << text << "\n";
    }
}

void setQuiet(bool quiet) {
    quietSoFar = quiet;
}

bool isQuiet() {
    return quietSoFar;
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
    if (errno == EPIPE) {  // who read it has seen enough
        return kSignalled + SIGPIPE;
    }
    const QString why = errno != 0 ? qt_error_string(errno) : QStringLiteral("it is closed or full");
    QTextStream(stderr) << "hitscope-cli: The standard output cannot be written: " << why << ".\n";
    return status == kGood || status == kDiffers ? kBadInput : status;  // nobody read what differs
}

}  // namespace hitscope::cli
