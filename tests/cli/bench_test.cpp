// SPDX-License-Identifier: GPL-3.0-or-later
// hitscope-cli bench as a person runs it. No time is asserted: machines differ.
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "cli/bench_runs.h"
#include "support/test_program.h"

namespace hitscope::bench_test {

using namespace test;

class BenchTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void paperGivesFramesOfEveryPipeline() {
        const CliRun run =
            runBench(QStringLiteral("paper --quick --rows 6 --size 64x36 --json "
                                    "--pipelines uniform-array,transform-feedback"));
        QVERIFY2(run.status == 0, qPrintable(run.err));
        QVERIFY2(run.err.isEmpty(), qPrintable(run.err));
        const QJsonObject json = QJsonDocument::fromJson(run.out.toUtf8()).object();
        QCOMPARE(json[QStringLiteral("report")].toString(), QStringLiteral("bench paper"));
        const QJsonObject header = json[QStringLiteral("header")].toObject();
        for (const char* name : {"program", "renderer", "OpenGL", "processor", "picture", "date", "note"}) {
            QVERIFY2(!header[QLatin1String(name)].toString().isEmpty(), name);
        }
        QVERIFY(header[QStringLiteral("note")].toString().contains(QStringLiteral("of this renderer")));
        const QJsonArray records = recordsOf(run.out);
        // Transform feedback with hits arriving, applied by it and as the paper does, and without.
        QCOMPARE(records.size(), 4);
        for (const auto& record : records) {
            QCOMPARE(number(record, "row"), 6.0);
            QCOMPARE(number(record, "lp_spheres"), 10.0);
            QCOMPARE(number(record, "hits_present"), 600.0);
            QVERIFY(number(record, "samples") >= 2.0);
            QVERIFY(number(record, "fps_median") > 0.0);
            QVERIFY(number(record, "fps_low") <= number(record, "fps_median"));
            QVERIFY(number(record, "fps_high") >= number(record, "fps_median"));
            QVERIFY(number(record, "fps_ratio_to_uniform_array") > 0.0);
        }
        QCOMPARE(text(records[0], "paper_l2"), QStringLiteral("200-350"));
        QCOMPARE(number(records[1], "hit_every"), 10.0);
        QVERIFY(number(records[1], "time_ratio_to_no_hits") > 0.0);
        QCOMPARE(text(records[1], "hits_by"), QStringLiteral("pipeline"));
        QCOMPARE(text(records[1], "paper_ratio_l1"), QStringLiteral("x1.17-2.83"));
        QCOMPARE(text(records[2], "hits_by"), QStringLiteral("paper"));
        QCOMPARE(number(records[2], "hit_every"), 10.0);
        QVERIFY(number(records[2], "time_ratio_to_no_hits") > 0.0);
        QCOMPARE(number(records[3], "hit_every"), 0.0);
    }

    void sessionMeasuresWhatKeepsIt() {
        const CliRun run = runBench(QStringLiteral("session --quick --hits 300 --json"));
        QVERIFY2(run.status == 0, qPrintable(run.err));
        const QJsonArray records = recordsOf(run.out);
        QStringList measured;
        for (const auto& record : records) {
            measured << text(record, "measured");
            QCOMPARE(number(record, "hits"), 300.0);
            QVERIFY(number(record, "samples") >= 2.0);
            QVERIFY(number(record, "seconds_median") > 0.0);
        }
        QCOMPARE(measured,
                 QStringList({QStringLiteral("save"), QStringLiteral("capture"), QStringLiteral("open"),
                              QStringLiteral("recover"), QStringLiteral("undo all"),
                              QStringLiteral("redo all"), QStringLiteral("hit"),
                              QStringLiteral("hit with journal"), QStringLiteral("settings to journal")}));
    }

    void ioMeasuresWhatComesInAndGoesOut() {
        const CliRun run =
            runBench(QStringLiteral("io --quick --quads 900 --triangles 200 --size 64x36 --json --strict"));
        QVERIFY2(run.status == 0 || run.status == 1, qPrintable(run.err));
        const QJsonArray records = recordsOf(run.out);
        QStringList measured;
        for (const auto& record : records) {
            measured << text(record, "measured");
            QVERIFY2(number(record, "value") > 0.0, qPrintable(measured.last()));
        }
        QCOMPARE(measured, QStringList({QStringLiteral("tinyobjloader"), QStringLiteral("assimp"),
                                        QStringLiteral("first picture"), QStringLiteral("picture"),
                                        QStringLiteral("cp"), QStringLiteral("export few"),
                                        QStringLiteral("export all"), QStringLiteral("memory"),
                                        QStringLiteral("ply")}));
        QCOMPARE(number(records[2], "at_most"), 2.0);
        QCOMPARE(number(records[5], "at_most"), 1.5);
        QCOMPARE(number(records[6], "at_most"), 3.0);
        QVERIFY(number(records[2], "ratio") > 0.0);
        bool allKept = true;
        for (const auto& record : records) {
            allKept = allKept && record.toObject()[QStringLiteral("kept")].toBool(true);
        }
        QCOMPARE(run.status == 0, allKept);
    }

    // Table 2 has the paper's way beside Hitscope's, and the paper's ratio stands beside the measured ones.
    void paperStandsBesidePaper() {
        const CliRun run =
            runBench(QStringLiteral("paper --quick --rows 6 --size 64x36 --pipelines "
                                    "uniform-array,transform-feedback"));
        QVERIFY2(run.status == 0, qPrintable(run.err));
        const QString table2 = run.out.mid(run.out.indexOf(QStringLiteral("Table 2: Transform feedback")));
        const qsizetype papers = table2.indexOf(QStringLiteral("the paper's way, FPS"));
        const qsizetype ours = table2.indexOf(QStringLiteral("Hitscope's, FPS"));
        QVERIFY2(papers > 0 && ours > papers, qPrintable(run.out));
        QVERIFY2(run.out.contains(QRegularExpression(
                     QStringLiteral("10 +0 +x1\\.17-2\\.83 +x0\\.429-3\\.80?( +x[0-9.]+){2}( +[0-9.]+){2}"))),
                 qPrintable(run.out));
    }

    void paperPutsTexturesOn() {
        const QTemporaryDir folder;
        const QString csv = folder.filePath(QStringLiteral("r.csv"));
        const CliRun run =
            runBench(QStringLiteral("paper --quick --rows 6 --size 64x36 --textures none,1k --hit-every 0 "
                                    "--pipelines transform-feedback --csv ") +
                     csv);
        QVERIFY2(run.status == 0, qPrintable(run.err));
        QVERIFY(
            run.out.contains(QStringLiteral("Table 2: Transform feedback; 600 hits present; textures: 1k")));
        QFile file(csv);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QStringList lines;
        for (const QString& line : QString::fromUtf8(file.readAll()).split(QLatin1Char('\n'))) {
            if (!line.isEmpty() && !line.startsWith(QLatin1Char('#'))) {
                lines << line;
            }
        }
        QCOMPARE(lines.size(), 3);
        QCOMPARE(lines[1].count(QLatin1Char(',')), lines[0].count(QLatin1Char(',')));
        QVERIFY(lines[2].contains(QStringLiteral(",1k,")));
    }

    void frameComparesHistories() {
        const CliRun run =
            runBench(QStringLiteral("frame --quick --gentle --size 64x36 --vertices 500 --hits 0,700 --json "
                                    "--pipelines uniform-array,transform-feedback"));
        QVERIFY2(run.status == 0, qPrintable(run.err));
        const QJsonArray records = recordsOf(run.out);
        QCOMPARE(records.size(), 4);
        QCOMPARE(number(records[0], "time_ratio_to_no_hits"), 1.0);
        QCOMPARE(number(records[1], "hits"), 700.0);
        QCOMPARE(number(records[1], "hits_kept"), 600.0);
        QCOMPARE(number(records[3], "hits_kept"), 700.0);
    }

    void hitComparesSizes() {
        const CliRun run = runBench(QStringLiteral(
            "hit --quick --vertices 1K,7938 --hits-a-frame 1,10 --pipelines transform-feedback"));
        QVERIFY2(run.status == 0, qPrintable(run.err));
        QVERIFY(run.out.contains(QStringLiteral("The paper's own way")));
        QVERIFY(run.out.contains(QStringLiteral("memcpy")));
        QVERIFY2(run.out.contains(QRegularExpression(
                     QStringLiteral("Time a hit over that on [0-9,]+ vertices, one hit a frame\n"))),
                 qPrintable(run.out));
        const CliRun ten = runBench(
            QStringLiteral("hit --quick --vertices 500,1K --hits-a-frame 10 --pipelines transform-feedback"));
        QVERIFY2(ten.status == 0, qPrintable(ten.err));
        const qsizetype growth = ten.out.indexOf(QStringLiteral(" vertices, 10 hits a frame\n"));
        QVERIFY2(growth > 0 && !ten.out.contains(QStringLiteral("one hit a frame")), qPrintable(ten.out));
        for (const char* method : {"Transform feedback", "The paper's own way", "memcpy"}) {
            QVERIFY2(ten.out.indexOf(QLatin1String(method), growth) > 0, method);
        }
    }

    void physicsMeasuresStepsCollidersAndFrames() {
        const CliRun run = runBench(QStringLiteral("physics --quick --triangles 8000,30000 --json"));
        QVERIFY2(run.status == 0, qPrintable(run.err));
        const QJsonArray records = recordsOf(run.out);
        QCOMPARE(records.size(), 10);
        QCOMPARE(text(records[0], "measured"), QStringLiteral("step in flight"));
        QCOMPARE(text(records[7], "measured"), QStringLiteral("collider and hull"));
        QVERIFY(number(records[7], "triangles") > 25000.0);
        for (const auto& record : records) {
            QVERIFY(number(record, "seconds_median") > 0.0);
            QVERIFY(number(record, "seconds_most") >= number(record, "seconds_median"));
        }
    }

    void checkMeasuresOne() {
        const CliRun run = runBench(QStringLiteral("check --quick --only paper-way-8k --json"));
        QVERIFY2(run.status == 0, qPrintable(run.err));
        const QJsonArray records = recordsOf(run.out);
        QCOMPARE(records.size(), 1);
        QVERIFY(number(records[0], "ratio") > 0.0);
        QCOMPARE(number(records[0], "at_most"), 0.1);
        QVERIFY(records[0].toObject()[QStringLiteral("kept")].isBool());
    }

    void wrongUsageIsToldApart_data() {
        QTest::addColumn<QString>("arguments");
        QTest::addColumn<QString>("piece");
        QTest::addRow("nothing")
            << QString()
            << QStringLiteral(
                   "paper, frame, modes, hit, physics, session, io, latency, memory, check or "
                   "compare");
        QTest::addRow("unknown") << QStringLiteral("speed") << QStringLiteral("\"speed\"");
        QTest::addRow("size") << QStringLiteral("paper --size big") << QStringLiteral("--size");
        QTest::addRow("row") << QStringLiteral("paper --rows 10") << QStringLiteral("--rows");
        QTest::addRow("texture") << QStringLiteral("paper --textures 8k") << QStringLiteral("\"8k\"");
        QTest::addRow("pipeline") << QStringLiteral("frame --pipelines magic") << QStringLiteral("\"magic\"");
        QTest::addRow("hits") << QStringLiteral("frame --hits many") << QStringLiteral("\"many\"");
        QTest::addRow("vertices") << QStringLiteral("hit --vertices 3") << QStringLiteral("--vertices");
        QTest::addRow("triangles") << QStringLiteral("physics --triangles 499")
                                   << QStringLiteral("--triangles");
        QTest::addRow("more than an import takes")
            << QStringLiteral("io --triangles 50M")
            << QStringLiteral("--triangles takes a whole number from 0 to");
        QTest::addRow("check") << QStringLiteral("check --only luck") << QStringLiteral("\"luck\"");
        QTest::addRow("file") << QStringLiteral("io out.json") << QStringLiteral("bench io takes no files");
        QTest::addRow("two outputs") << QStringLiteral("hit --json --csv -")
                                     << QStringLiteral("--json and --csv both write");
        QTest::addRow("the report twice")
            << QStringLiteral("hit --json --report -") << QStringLiteral("only one of --json");
        QTest::addRow("window") << QStringLiteral("latency --size 5x5") << QStringLiteral("--size");
        QTest::addRow("sheet") << QStringLiteral("latency --vertices 3") << QStringLiteral("--vertices");
        QTest::addRow("scattered") << QStringLiteral("latency --scattered x")
                                   << QStringLiteral("--scattered");
        QTest::addRow("no hits") << QStringLiteral("memory --hits 0") << QStringLiteral("--hits");
        QTest::addRow("option") << QStringLiteral("check --fast") << QStringLiteral("fast");
    }
    void wrongUsageIsToldApart() {
        QFETCH(QString, arguments);
        QFETCH(QString, piece);
        const CliRun run = runBench(arguments);
        QCOMPARE(run.status, 2);
        QVERIFY(run.out.isEmpty());
        QVERIFY2(run.err.contains(piece), qPrintable(run.err));
    }

    void fileThatCannotBeWrittenFailsAtOnce() {
        const CliRun run = runBench(QStringLiteral("paper --report /nowhere/at/all.json"));
        QCOMPARE(run.status, 3);
        QVERIFY2(run.err.contains(QStringLiteral("/nowhere/at/all.json")), qPrintable(run.err));
        QVERIFY(run.out.isEmpty());
    }

    void whereNothingDrawsItEndsWithFour() {
        const QTemporaryDir folder;
        const QString page = folder.filePath(QStringLiteral("page.html"));
        const CliRun run = runCli({"bench", "hit", "--quick", "--vertices", "500", "--html", page},
                                  {{QStringLiteral("MESA_GL_VERSION_OVERRIDE"), QStringLiteral("2.1")}});
        if (run.status == 0 && !isLlvmpipe()) {
            QSKIP("This driver cannot be told to offer less.");
        }
        QCOMPARE(run.status, 4);
        QVERIFY2(run.err.contains(QStringLiteral("OpenGL 3.3")) && run.err.count(u'\n') == 1,
                 qPrintable(run.err));
        QVERIFY(run.out.isEmpty() && !QFile::exists(page));
    }

    /// Each row, size or pipeline that a promise speaks of; the worst is named.
    void checkMeasuresEachRow() {
        const QTemporaryDir folder;
        QFile report(folder.filePath(QStringLiteral("check.json")));
        const CliRun run =
            runBench(QStringLiteral("check --quick --only arriving-hits --report ") + report.fileName());
        QVERIFY2(run.status == 0, qPrintable(run.err));
        QVERIFY(report.open(QIODevice::ReadOnly));
        const QJsonArray records = recordsOf(QString::fromUtf8(report.readAll()));
        QCOMPARE(records.size(), 9);
        for (int row = 0; row < 9; ++row) {
            QCOMPARE(text(records[row], "where"), QStringLiteral("row %1").arg(row + 1));
            QVERIFY(number(records[row], "ratio") > 0.0);
        }
        QCOMPARE(run.out.count(QStringLiteral(" (worst) ")), 1);
    }

    void helpIsGiven() {
        const CliRun all = runBench(QStringLiteral("--help"));
        QVERIFY(all.out.startsWith(QStringLiteral("Usage: hitscope-cli bench WHAT [options]\n")));
        for (const char* what :
             {"paper", "frame", "modes", "hit", "physics", "session", "io", "latency", "check"}) {
            const QString name = QLatin1String(what);
            QVERIFY2(all.out.contains(QStringLiteral("\n  %1 ").arg(name)), what);
            const CliRun run = runBench(name + QStringLiteral(" --help"));
            QCOMPARE(run.status, 0);
            QVERIFY2(run.out.startsWith(QStringLiteral("Usage: hitscope-cli bench %1 [options]\n").arg(name)),
                     what);
            QVERIFY2(run.out.contains(QStringLiteral("Default: 100.")), what);
            QVERIFY2(run.out.contains(QStringLiteral("\n  hitscope-cli bench %1 --quick").arg(name)), what);
            QCOMPARE(runCli({QStringLiteral("help"), QStringLiteral("bench"), name}).out, run.out);
        }
    }
};

HITSCOPE_TEST(BenchTest, QCoreApplication)

}  // namespace hitscope::bench_test

#include "bench_test.moc"
