// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProcess>
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

}  // namespace hitscope::test
