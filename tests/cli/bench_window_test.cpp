// SPDX-License-Identifier: GPL-3.0-or-later
// hitscope-cli bench latency and bench memory, which use the window. No time is asserted: machines differ.
#include <signal.h>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "cli/bench_runs.h"
#include "core/process_memory.h"
#include "support/test_program.h"

namespace hitscope::bench_window_test {

using namespace test;

namespace {

QByteArray readWhole(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// The process of the window that hitscope-cli has started; 0: there is none.
qint64 windowOf(qint64 command) {
    for (const std::int64_t child : childrenOf(command)) {
        if (readWhole(QStringLiteral("/proc/%1/comm").arg(child)).startsWith("hitscope-bench-")) {
            return child;
        }
    }
    return 0;
}

/// Not yet ended, whoever may have to take note of that.
bool isRunning(qint64 process) {
    const QByteArray status = readWhole(QStringLiteral("/proc/%1/status").arg(process));
    return !status.isEmpty() && !status.contains("State:\tZ");
}

QStringList allIn(const QString& folder) {
    return QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
}

}  // namespace

class BenchWindowTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void latencyMeasuresTheWindow() {
        const CliRun run = runBench(
            QStringLiteral("latency --quick --vertices 500,900 --size 400x300 --scattered 20 --json"));
        if (run.status == 4 && run.err.contains(QStringLiteral("install Xvfb"))) {
            QSKIP("no Xvfb");
        }
        QVERIFY2(run.status == 0, qPrintable(run.err));
        const QStringList wanted{QStringLiteral("teapot, rest to refined picture"),
                                 QStringLiteral("teapot, turned, rest to refined picture"),
                                 QStringLiteral("open to picture"),
                                 QStringLiteral("click to dent"),
                                 QStringLiteral("click to dent, instant"),
                                 QStringLiteral("undo key to picture"),
                                 QStringLiteral("redo key to picture"),
                                 QStringLiteral("frame at rest"),
                                 QStringLiteral("frame in motion, full size"),
                                 QStringLiteral("frame in motion"),
                                 QStringLiteral("aim preview, rest to picture"),
                                 QStringLiteral("aim preview, over a refined picture"),
                                 QStringLiteral("export, OBJ"),
                                 QStringLiteral("export, GLB"),
                                 QStringLiteral("scatter, previewed"),
                                 QStringLiteral("scatter, applied"),
                                 QStringLiteral("scatter, undone"),
                                 QStringLiteral("scatter, redone"),
                                 QStringLiteral("frame in motion, close up")};
        for (const int vertices : {500, 900}) {
            QStringList measured;
            for (const auto& record : recordsOf(run.out)) {
                if (std::abs(number(record, "vertices") - vertices) > 0.1 * vertices ||
                    text(record, "measured") == QLatin1String("open to coarse picture") ||
                    text(record, "measured").endsWith(QLatin1String(", in full"))) {
                    continue;  // it depends on the machine whether a coarse picture comes first
                }
                measured << text(record, "measured");
                QVERIFY2(number(record, "seconds_median") > 0.0, qPrintable(measured.last()));
                QVERIFY(number(record, "seconds_least") <= number(record, "seconds_median"));
                QVERIFY(number(record, "seconds_most") >= number(record, "seconds_median"));
                QVERIFY2(number(record, "blocked_most") > 0.0, qPrintable(measured.last()));
                QVERIFY2(number(record, "processor_median") > 0.0, qPrintable(measured.last()));
                QVERIFY(number(record, "moved") > 0.0);
            }
            QCOMPARE(measured, wanted);
        }
    }

    void memoryMeasuresTheWindow() {
        const QTemporaryDir folder;
        const QString report = folder.filePath(QStringLiteral("memory.json"));
        const CliRun run = runBench(
            QStringLiteral("memory --vertices 2000,2001 --size 400x300 --hits 5 --json --report ") + report);
        if (run.status == 4 && run.err.contains(QStringLiteral("install Xvfb"))) {
            QSKIP("no Xvfb");
        }
        QVERIFY2(run.status == 0, qPrintable(run.err));
        QStringList measured;
        for (const auto& record : recordsOf(run.out)) {
            measured << text(record, "measured");
            QCOMPARE(number(record, "hits"), 5.0);
            if (text(record, "measured") != QLatin1String("hit")) {
                QVERIFY(number(record, "share") > 1.0e6);
                QCOMPARE(record.toObject()[QStringLiteral("runs")].toArray(),
                         QJsonArray{number(record, "share")});
                QCOMPARE(text(record, "unit"), QStringLiteral("B"));
            }
        }
        QVERIFY2(run.out.contains(QStringLiteral("2,001 vertices make the same mesh")), qPrintable(run.out));
        const CliRun compared = compareWithCopy(report);
        QVERIFY2(compared.status == 0, qPrintable(compared.err));
        QCOMPARE(measured,
                 QStringList({QStringLiteral("start"), QStringLiteral("opened"), QStringLiteral("first"),
                              QStringLiteral("hits"), QStringLiteral("undone"), QStringLiteral("closed"),
                              QStringLiteral("hit"), QStringLiteral("worker")}));
    }

    void windowWithoutAnyDisplaySaysWhatToInstall() {
        for (const char* what : {"latency", "memory"}) {
            const CliRun run = runCli({QStringLiteral("bench"), QLatin1String(what)},
                                      {{QStringLiteral("PATH"), QStringLiteral("/nowhere")}});
            QCOMPARE(run.status, 4);
            QVERIFY2(run.err.contains(QStringLiteral("install Xvfb")), qPrintable(run.err));
        }
    }

    void windowOnADisplayThatIsNotThereSaysSo() {
        const CliRun run = runCli({QStringLiteral("bench"), QStringLiteral("latency"),
                                   QStringLiteral("--vertices"), QStringLiteral("500")},
                                  {{QStringLiteral("DISPLAY"), QStringLiteral(":65535")},
                                   {QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("xcb")}});
        QCOMPARE(run.status, 4);
        QVERIFY2(run.err.contains(QStringLiteral("could not connect to display :65535")),
                 qPrintable(run.err));
        QVERIFY2(!run.err.contains(QStringLiteral("crashed")) && run.err.count(u'\n') == 1,
                 qPrintable(run.err));
    }

    /// While the window has its settings, its journal and the mesh in temporary folders.
    void windowLeavesNothingWhenItIsEnded_data() {
        QTest::addColumn<bool>("endsWindow");
        QTest::newRow("the command") << false;
        QTest::newRow("the window alone") << true;
    }
    void windowLeavesNothingWhenItIsEnded() {
        QFETCH(bool, endsWindow);
        if (QStandardPaths::findExecutable(QStringLiteral("Xvfb")).isEmpty()) {
            QSKIP("no Xvfb");
        }
        const QTemporaryDir folder;
        const QString temporary = folder.filePath(QStringLiteral("tmp"));
        QVERIFY(QDir().mkpath(temporary));
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("TMPDIR"), temporary);
        environment.insert(QStringLiteral("XDG_RUNTIME_DIR"), folder.path());  // else Qt makes a folder there
        environment.remove(QStringLiteral("DISPLAY"));
        environment.remove(QStringLiteral("WAYLAND_DISPLAY"));
        process.setProcessEnvironment(environment);
        process.start(qEnvironmentVariable("HITSCOPE_CLI"),
                      {"bench", "memory", "--vertices", "500", "--size", "400x300", "--hits", "100000"});
        const auto isThere = [&temporary](const char* name) {
            return !QDir(temporary).entryList({QLatin1String(name)}, QDir::Dirs).isEmpty();
        };
        QTRY_VERIFY_WITH_TIMEOUT(isThere("hitscope-bench-*"), 100'000);  // the window's
        QVERIFY(isThere("hitscope-??????"));                             // the command's
        const qint64 window = windowOf(process.processId());
        QVERIFY(window != 0);
        ::kill(static_cast<pid_t>(endsWindow ? window : process.processId()), SIGTERM);
        QVERIFY(process.waitForFinished(60'000));
        QCOMPARE(process.exitStatus(), endsWindow ? QProcess::NormalExit : QProcess::CrashExit);
        QTRY_VERIFY_WITH_TIMEOUT(!isRunning(window), 60'000);
        QCOMPARE(allIn(temporary), QStringList());
    }
};

HITSCOPE_TEST(BenchWindowTest, QCoreApplication)

}  // namespace hitscope::bench_window_test

#include "bench_window_test.moc"
