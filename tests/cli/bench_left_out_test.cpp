// SPDX-License-Identifier: GPL-3.0-or-later
// What benchmarks leave out: pipelines that do not run here, and sizes that are the same.
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "cli/bench_runs.h"
#include "support/test_program.h"

namespace hitscope::bench_left_out_test {

using namespace test;

class BenchLeftOutTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// Where a pipeline does not run, those that do are measured, and where none does that is an error.
    void pipelinesThatDoNotRunAreLeftOut_data() {
        QTest::addColumn<QString>("arguments");
        QTest::newRow("paper") << QStringLiteral("paper --quick --rows 6 --size 64x36 --hit-every 0");
        QTest::newRow("frame") << QStringLiteral("frame --quick --vertices 500 --hits 0 --size 64x36");
        QTest::newRow("modes") << QStringLiteral("modes --quick --row 6 --size 64x36");
    }
    void pipelinesThatDoNotRunAreLeftOut() {
        QFETCH(QString, arguments);
        const auto withoutCompute = [&arguments](const char* pipelines) {
            return runCli(QStringList{QStringLiteral("bench")} + arguments.split(u' ') +
                              QStringList{QStringLiteral("--json"), QStringLiteral("--pipelines"),
                                          QLatin1String(pipelines)},
                          {{QStringLiteral("MESA_GL_VERSION_OVERRIDE"), QStringLiteral("3.3")}});
        };
        const CliRun alone = withoutCompute("compute");
        if (alone.status == 0 && !isLlvmpipe()) {
            QSKIP("This driver cannot be told to offer less.");
        }
        QCOMPARE(alone.status, 4);
        QVERIFY2(alone.err.contains(QStringLiteral("Compute cannot run here")) && alone.err.count(u'\n') == 1,
                 qPrintable(alone.err));
        QVERIFY(alone.out.isEmpty());
        const CliRun both = withoutCompute("compute,transform-feedback");
        QVERIFY2(both.status == 0, qPrintable(both.err));
        QVERIFY(both.out.contains(QStringLiteral("Compute cannot run here")));
        QVERIFY(!recordsOf(both.out).isEmpty());
        for (const auto& record : recordsOf(both.out)) {
            QCOMPARE(text(record, "pipeline"), QStringLiteral("transform-feedback"));
        }
    }

    void strictExcusesPipelinesThatDoNotRun() {
        const CliRun run =
            runCli({"bench", "check", "--quick", "--strict", "--only", "size-compute", "--json"},
                   {{QStringLiteral("MESA_GL_VERSION_OVERRIDE"), QStringLiteral("3.3")}});
        const QJsonArray records = recordsOf(run.out);
        QCOMPARE(records.size(), 1);
        if (!records[0].toObject()[QStringLiteral("kept")].isNull() && !isLlvmpipe()) {
            QSKIP("This driver cannot be told to offer less.");
        }
        QVERIFY(records[0].toObject()[QStringLiteral("kept")].isNull());
        QVERIFY2(run.status == 0, qPrintable(run.err));
    }

    /// "8K" is the paper's sphere too. bench compare refuses a report in which a row comes twice.
    void equalSizesAreMeasuredOnce_data() {
        QTest::addColumn<QString>("arguments");
        QTest::newRow("hit") << QStringLiteral(
            "hit --vertices 8K,7938 --hits-a-frame 1 --pipelines transform-feedback");
        QTest::newRow("frame") << QStringLiteral(
            "frame --vertices 8K,7938 --hits 0 --size 64x36 --pipelines transform-feedback");
        QTest::newRow("physics") << QStringLiteral("physics --triangles 600,601 --size 64x36");
    }
    void equalSizesAreMeasuredOnce() {
        QFETCH(QString, arguments);
        const QTemporaryDir folder;
        const QString report = folder.filePath(QStringLiteral("r.json"));
        const CliRun run = runBench(arguments + QStringLiteral(" --quick --report ") + report);
        QVERIFY2(run.status == 0, qPrintable(run.err));
        QVERIFY2(run.out.contains(QStringLiteral("make the same mesh as a size before")),
                 qPrintable(run.out));
        const CliRun compared = compareWithCopy(report);
        QVERIFY2(compared.status == 0, qPrintable(compared.err));
    }
};

HITSCOPE_TEST(BenchLeftOutTest, QCoreApplication)

}  // namespace hitscope::bench_left_out_test

#include "bench_left_out_test.moc"
