// SPDX-License-Identifier: GPL-3.0-or-later
// What takes long says so where a person watches, and nowhere else.
#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <array>

#include "cli/run_cli.h"
#include "cli/scene_files.h"
#include "io/descriptor.h"
#include "support/test_program.h"

namespace hitscope::progress_test {

using namespace test;

namespace {

/// As runCli(), with a terminal as the standard error.
CliRun runAtTerminal(const QStringList& arguments) {
    constexpr int kPatience = 100'000;  // milliseconds
    CliRun run;
    const Descriptor terminal(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK));
    if (!terminal.isOpen() || ::grantpt(terminal.get()) != 0 || ::unlockpt(terminal.get()) != 0) {
        return run;
    }
    const QByteArray name = ::ptsname(terminal.get());
    // Held, so that what was written stays when the program has gone.
    const Descriptor held(::open(name.constData(), O_RDWR | O_NOCTTY | O_CLOEXEC));
    QProcess process;
    process.setChildProcessModifier([&held] { ::dup2(held.get(), STDERR_FILENO); });
    process.start(qEnvironmentVariable("HITSCOPE_CLI"), arguments);
    if (process.waitForFinished(kPatience) && process.exitStatus() == QProcess::NormalExit) {
        run.status = process.exitCode();
    }
    run.out = QString::fromUtf8(process.readAllStandardOutput());
    std::array<char, 4096> bytes{};
    for (ssize_t read = 1; read > 0;) {
        read = ::read(terminal.get(), bytes.data(), bytes.size());
        run.err += QString::fromUtf8(bytes.data(), std::max<ssize_t>(read, 0));
    }
    return run;
}

}  // namespace

class ProgressTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { writeBytes(m_folder.filePath(QStringLiteral("ball.obj")), ballObj()); }

    void scatteringIsSaidAtATerminal() {
        const CliRun run = runAtTerminal(m_long);
        QVERIFY2(run.status == 0, qPrintable(run.err));
        QVERIFY2(run.err.contains(QStringLiteral("\rScattering hits")), qPrintable(run.err));
        QVERIFY2(run.err.endsWith(u'\r'), qPrintable(run.err));  // and it is gone afterwards
    }

    void nothingIsSaidElsewhere() {
        const CliRun run = runCli(m_long);
        QVERIFY2(run.status == 0 && run.err.isEmpty(), qPrintable(run.err));
        const CliRun quiet = runAtTerminal(m_long + QStringList{"--quiet"});
        QVERIFY2(quiet.status == 0 && quiet.err.isEmpty(), qPrintable(quiet.err));
        QCOMPARE(quiet.out, run.out);
    }

private:
    QTemporaryDir m_folder;
    /// Of a number that takes seconds.
    QStringList m_long{"shoot",     "--pipeline", "reference",
                       "--scatter", "30000",      m_folder.filePath(QStringLiteral("ball.obj"))};
};

HITSCOPE_TEST(ProgressTest, QCoreApplication)

}  // namespace hitscope::progress_test

#include "progress_test.moc"
