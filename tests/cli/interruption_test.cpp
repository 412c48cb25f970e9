// SPDX-License-Identifier: GPL-3.0-or-later
// hitscope-cli where somebody ends it, or reads on no more.
#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>

#include "cli/run_cli.h"
#include "cli/scene_files.h"
#include "support/test_program.h"

namespace hitscope::interruption_test {

using namespace test;

class InterruptionTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void signalsLeaveNothing_data();
    void signalsLeaveNothing();
    void signalsSwitchedOffStaySo();
    void pipesMayClose();
    void helpTakesNeitherFontsNorMeshes();

private:
    QTemporaryDir m_folder;
};

void InterruptionTest::signalsLeaveNothing_data() {
    QTest::addColumn<int>("signal");
    QTest::newRow("Ctrl+C") << SIGINT;
    QTest::newRow("end") << SIGTERM;
    QTest::newRow("hang up") << SIGHUP;
}

/// In the middle of a film, whose pictures are temporary files.
void InterruptionTest::signalsLeaveNothing() {
    QFETCH(int, signal);
    const QString temporary = m_folder.filePath(QStringLiteral("tmp"));
    QVERIFY(QDir().mkpath(temporary));
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("TMPDIR"), temporary);
    environment.insert(QStringLiteral("XDG_RUNTIME_DIR"), m_folder.path());  // else Qt makes a folder there
    // Any program will do: it is not come to.
    const QString programs = m_folder.filePath(QStringLiteral("bin"));
    QVERIFY(QDir().mkpath(programs));
    QFile::link(QStringLiteral("/bin/true"), programs + QStringLiteral("/ffmpeg"));
    environment.insert(QStringLiteral("PATH"), programs + u':' + environment.value(QStringLiteral("PATH")));
    process.setProcessEnvironment(environment);
    process.start(
        qEnvironmentVariable("HITSCOPE_CLI"),
        {"sequence", "--turntable", "100000", "--size", "64x48", m_folder.filePath(QStringLiteral("a.mp4"))});
    const auto pictures = [&temporary] {
        for (const QString& folder : QDir(temporary).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
            if (QDir(temporary + u'/' + folder + QStringLiteral("/pictures")).entryList(QDir::Files).size() >
                3) {
                return true;
            }
        }
        return false;
    };
    QTRY_VERIFY_WITH_TIMEOUT(pictures(), 100'000);
    QCOMPARE(process.state(), QProcess::Running);
    ::kill(static_cast<pid_t>(process.processId()), signal);
    QVERIFY(process.waitForFinished(60'000));
    QCOMPARE(process.exitStatus(), QProcess::CrashExit);  // by the signal itself: shells say 128 + n
    QCOMPARE(process.exitCode(), signal);
    QCOMPARE(QDir(temporary).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
             QStringList());
    QVERIFY(!QFile::exists(m_folder.filePath(QStringLiteral("a.mp4"))));
}

/// Pictures go on after the one that is switched off.
void InterruptionTest::signalsSwitchedOffStaySo() {
    const QString frames = m_folder.filePath(QStringLiteral("frames"));
    const auto pictures = [&frames] { return QDir(frames).entryList(QDir::Files).size(); };
    QProcess process;
    process.start(
        "bash", {"-c", "trap '' INT; exec \"$HITSCOPE_CLI\" sequence --turntable 100000 --size 64x48 \"$0\"",
                 frames});
    QTRY_VERIFY_WITH_TIMEOUT(pictures() > 3, 100'000);
    QCOMPARE(process.state(), QProcess::Running);
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    const qsizetype before = pictures();
    QTRY_VERIFY_WITH_TIMEOUT(pictures() > before + 10 || process.state() == QProcess::NotRunning, 100'000);
    QCOMPARE(process.state(), QProcess::Running);
    ::kill(static_cast<pid_t>(process.processId()), SIGTERM);
    QVERIFY(process.waitForFinished(60'000));
    QCOMPARE(process.exitStatus(), QProcess::CrashExit);
    QCOMPARE(process.exitCode(), SIGTERM);
}

void InterruptionTest::pipesMayClose() {
    const QString mesh = writeBytes(m_folder.filePath(QStringLiteral("ball.obj")), ballObj(200, 300));
    QProcess shell;
    shell.start(
        "bash",
        {"-c", "\"$HITSCOPE_CLI\" convert --format obj \"$0\" - | head -n 1; echo ${PIPESTATUS[0]}", mesh});
    QVERIFY(shell.waitForFinished(100'000));
    QCOMPARE(shell.readAllStandardError(), QByteArray());
    QVERIFY(shell.readAllStandardOutput().endsWith("\n141\n"));
}

/// A platform that is not there would end a program with windows or fonts.
void InterruptionTest::helpTakesNeitherFontsNorMeshes() {
    for (const char* verb : {"picture", "sequence", "shoot"}) {
        const CliRun run =
            runCli({QString::fromLatin1(verb), "--help"}, {{"QT_QPA_PLATFORM_PLUGIN_PATH", "/nowhere"}});
        QVERIFY2(run.status == 0 && run.out.startsWith(QStringLiteral("Usage: hitscope-cli ")),
                 qPrintable(run.err));
    }
}

HITSCOPE_TEST(InterruptionTest, QCoreApplication)

}  // namespace hitscope::interruption_test

#include "interruption_test.moc"
