// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProcess>
#include <QRegularExpression>
#include <QStringList>
#include <utility>
#include <vector>

namespace hitscope::test {

struct CliRun {
    int status = -1;  ///< -1: it crashed, or did not end
    QString out;
    QString err;
};

/// hitscope-cli as a person runs it where there is no display at all. `more`: {variable, value} pairs.
inline CliRun runCli(const QStringList& arguments,
                     const std::vector<std::pair<QString, QString>>& more = {}) {
    constexpr int kPatience = 100'000;  // milliseconds
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove(QStringLiteral("DISPLAY"));
    environment.remove(QStringLiteral("WAYLAND_DISPLAY"));
    for (const auto& [variable, value] : more) {
        environment.insert(variable, value);
    }
    process.setProcessEnvironment(environment);
    process.start(qEnvironmentVariable("HITSCOPE_CLI"), arguments);
    CliRun run;
    if (process.waitForFinished(kPatience) && process.exitStatus() == QProcess::NormalExit) {
        run.status = process.exitCode();
    }
    run.out = QString::fromUtf8(process.readAllStandardOutput());
    run.err = QString::fromUtf8(process.readAllStandardError());
    return run;
}

/// What `info --renderer` says of the renderer that tests draw with.
inline const QString& rendererReport() {
    static const QString report = runCli({QStringLiteral("info"), QStringLiteral("--renderer")}).out;
    return report;
}

/// Mesa's llvmpipe, which obeys the variables that make it offer less; where tests draw with another driver,
/// it may heed none of them.
inline bool isLlvmpipe() {
    static const QRegularExpression row(QStringLiteral("^ *renderer +llvmpipe"),
                                        QRegularExpression::MultilineOption);
    return rendererReport().contains(row);
}

/// Whether GALLIUM_OVERRIDE_CPU_CAPS=nosse makes its arithmetic inexact: it is about x86 alone.
inline bool isMadeInexact() {
#ifdef Q_PROCESSOR_X86
    return isLlvmpipe();
#else
    return false;
#endif
}

}  // namespace hitscope::test
