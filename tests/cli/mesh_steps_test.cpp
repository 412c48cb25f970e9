// SPDX-License-Identifier: GPL-3.0-or-later
// What is done to meshes as they are read, and to sessions up to a hit.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "cli/run_cli.h"
#include "cli/scene_files.h"
#include "support/test_program.h"

namespace hitscope::mesh_steps_test {

using namespace test;

class MeshStepsTest : public QObject {
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    [[nodiscard]] QString in(const QString& name) const { return m_folder.filePath(name); }

    [[nodiscard]] static QJsonObject jsonOf(const CliRun& run) {
        return QJsonDocument::fromJson(run.out.toUtf8()).object();
    }
    /// Of the original mesh of a file.
    [[nodiscard]] static QJsonObject measured(const QString& mesh) {
        return jsonOf(runCli({"info", "--json", mesh}))["files"]
            .toArray()[0]
            .toObject()["targets"]
            .toArray()[0]
            .toObject()["original"]
            .toObject();
    }
    [[nodiscard]] static QJsonArray dentsOf(const QStringList& more) {
        return jsonOf(runCli(QStringList{"dents", "--json"} + more))["targets"]
            .toArray()[0]
            .toObject()["dents"]
            .toArray();
    }

private Q_SLOTS:
    void initTestCase() { writeBytes(in("ball.obj"), ballObj()); }

    void convertingSimplifiesRefinesAndSmooths() {
        const QJsonObject before = measured(in("ball.obj"));
        const auto converted = [this](const QStringList& options) {
            const QString path = in("made.ply");
            const CliRun run =
                runCli(QStringList{"convert", "--check"} + options + QStringList{in("ball.obj"), path});
            return run.status == 0 ? measured(path) : QJsonObject();
        };
        const QJsonObject light = converted({"--simplify", "25"});
        constexpr double kTriangles = 24 * (2 + 14 * 2);  // of the ball, its quads cut in two
        const double share = light["faces"].toDouble() / kTriangles;
        QVERIFY2(share > 0.2 && share < 0.3, qPrintable(QString::number(share)));
        const QJsonObject fine = converted({"--refine", "0.1"});
        QVERIFY(fine["vertices"].toInt() > 3 * before["vertices"].toInt());
        const QJsonObject smooth = converted({"--smooth", "10"});
        QCOMPARE(smooth["vertices"], before["vertices"]);
        QVERIFY(smooth["volume"].toDouble() < 0.95 * before["volume"].toDouble());
        // One after the other, whatever the order they are given in.
        const QJsonObject all = converted({"--refine", "0.1", "--simplify", "25"});
        QVERIFY(all["vertices"].toInt() > 2 * before["vertices"].toInt());
    }

    void convertingChangesUnitAndAxis() {
        const QJsonObject before = measured(in("ball.obj"));
        const QString path = in("big.ply");
        const CliRun run = runCli({"convert", "--check", "--scale", "10", "--up", "z", in("ball.obj"), path});
        QVERIFY2(run.status == 0 && run.err.isEmpty(), qPrintable(run.err));
        const QJsonObject after = measured(path);
        QCOMPARE(after["vertices"], before["vertices"]);
        const double ratio = after["volume"].toDouble() / before["volume"].toDouble();
        QVERIFY2(ratio > 999.9 && ratio < 1000.1, qPrintable(QString::number(ratio)));
        // And back, which a copy of the same file would not be told from.
        const QString back = in("back.obj");
        QCOMPARE(runCli({"convert", "--check", "--scale", "0.1", "--write-up", "z", path, back}).status, 0);
        QCOMPARE(runCli({"compare", "--tolerance", "1e-6", in("ball.obj"), back}).status, 0);
        QCOMPARE(runCli({"convert", "--scale", "0", in("ball.obj"), in("no.obj")}).status, 2);
        QVERIFY(!QFile::exists(in("no.obj")));
    }

    void shotsMeetTheChangedMesh() {
        const QString session = in("smooth.hitscope");
        const CliRun run = runCli({"shoot", "--at", "0,0,1", "--smooth", "10", "--simplify", "50",
                                   "--session", session, in("ball.obj")});
        QVERIFY2(run.status == 0, qPrintable(run.err));
        QCOMPARE(runCli({"replay", session}).status, 0);
        const QJsonArray steps =
            jsonOf(runCli({"shoot", "--at", "0,0,1", "--session", "-", session}))["targets"]
                .toArray()[0]
                .toObject()["mesh_steps"]
                .toArray();
        QCOMPARE(steps.size(), 2);
    }

    void stepsThatCannotBeAreRefused_data() {
        QTest::addColumn<QStringList>("options");
        QTest::newRow("nothing left") << QStringList{"--simplify", "0"};
        QTest::newRow("less than nothing left") << QStringList{"--simplify", "-3"};
        QTest::newRow("everything left") << QStringList{"--simplify", "100"};
        QTest::newRow("no pass") << QStringList{"--smooth", "0"};
        QTest::newRow("too many passes") << QStringList{"--smooth", "1001"};
        QTest::newRow("no length") << QStringList{"--refine", "0"};
        QTest::newRow("a length below 0") << QStringList{"--refine", "-1"};
        QTest::newRow("next to no length") << QStringList{"--refine", "1e-60"};
        QTest::newRow("a method without a length") << QStringList{"--refine-by", "butterfly"};
    }

    void stepsThatCannotBeAreRefused() {
        QFETCH(QStringList, options);
        const QString path = in("refused.ply");
        const CliRun run = runCli(QStringList{"convert"} + options + QStringList{in("ball.obj"), path});
        QCOMPARE(run.status, 2);
        QVERIFY2(!run.err.contains("from 0"), qPrintable(run.err));  // 0 is refused
        QVERIFY(!QFile::exists(path));
    }

    void sessionsAreReadUpToAHit() {
        const QString session = in("many.hitscope");
        const CliRun run =
            runCli({"shoot", "--random", "6", "--instant", "--session", session, in("ball.obj")});
        QVERIFY2(run.status == 0, qPrintable(run.err));
        QCOMPARE(dentsOf({"--until", "0", session}).size(), 0);
        const QJsonArray first = dentsOf({"--until", "1", session});
        QCOMPARE(first.size(), 1);
        QCOMPARE(first[0].toObject()["hits"].toArray(), QJsonArray{1});
        const auto changed = [&session](const char* until) {
            return runCli({"changes", "--until", QLatin1String(until), session}).out.count(u'\n');
        };
        QCOMPARE(changed("0"), 1);  // the heading
        QVERIFY(changed("1") > 1);
        QVERIFY(changed("1") < changed("6"));
        QCOMPARE(runCli({"changes", "--until", "7", session}).status, 3);
        const CliRun uncut = runCli({"section", "--plane", "z=0", "--until", "0", session});
        QCOMPARE(uncut.status, 0);
        QCOMPARE(runCli({"export", "--until", "1", "--format", "obj", "--out", "-", in("ball.obj")}).status,
                 2);
        QCOMPARE(runCli({"section", "--until", "1", "--plane", "z=0", in("ball.obj")}).status, 2);
    }

    void dentsAreWrittenAsATable() {
        const QString session = in("three.hitscope");
        QCOMPARE(runCli({"shoot", "--random", "3", "--instant", "--session", session, in("ball.obj")}).status,
                 0);
        const CliRun run = runCli({"dents", "--csv", "-", session});
        QCOMPARE(run.status, 0);
        const QStringList lines = run.out.trimmed().split(u'\n');
        const QJsonArray dents = dentsOf({session});
        QCOMPARE(lines.size(), dents.size() + 1);
        const QStringList heading = lines[0].split(u',');
        for (qsizetype i = 0; i < dents.size(); ++i) {
            const QStringList cells = lines[i + 1].split(u',');
            QCOMPARE(cells.size(), heading.size());
            for (const char* key : {"depth_m", "rim_diameter_m", "affected_area_m2", "displaced_volume_m3",
                                    "vertices", "deepest_vertex"}) {
                QCOMPARE(cells[heading.indexOf(QLatin1String(key))].toDouble(),
                         dents[i].toObject()[QLatin1String(key)].toDouble());
            }
        }
    }
};

HITSCOPE_TEST(MeshStepsTest, QCoreApplication)

}  // namespace hitscope::mesh_steps_test

#include "mesh_steps_test.moc"
