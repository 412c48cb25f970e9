// SPDX-License-Identifier: GPL-3.0-or-later
// `hitscope-cli shoot` as a person runs it, with no display.
#include <QImage>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <set>

#include "cli/run_cli.h"
#include "cli/scene_files.h"
#include "support/test_program.h"

namespace hitscope::shoot_test {

using namespace test;

namespace {

CliRun shoot(const QStringList& arguments) {
    return runCli(QStringList{QStringLiteral("shoot")} + arguments);
}

QString fingerprintOf(const CliRun& run) {
    return QRegularExpression(QStringLiteral("fingerprint ([0-9a-f]{16})")).match(run.out).captured(1);
}

}  // namespace

class ShootTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void burstsAndTheirScriptsHitTheSame() {
        const QTemporaryDir folder;
        const QString script = folder.filePath(QStringLiteral("shots.json"));
        const QStringList burst{"--burst", "60", "--cone", "12", "--seed", "3", "--every", "0.02"};
        const CliRun first = shoot(burst + QStringList{"--save", script});
        QVERIFY2(first.status == 0, qPrintable(first.err));
        QVERIFY2(first.out.startsWith(QStringLiteral("60 shots, ")), qPrintable(first.out));
        QVERIFY(!fingerprintOf(first).isEmpty());
        QCOMPARE(shoot(burst).out + QStringLiteral("In %1: the shots\n").arg(script), first.out);
        QCOMPARE(shoot({"--script", script}).out, shoot(burst).out);
        const CliRun other = shoot({"--burst", "60", "--cone", "12", "--seed", "4", "--every", "0.02"});
        QVERIFY(fingerprintOf(other) != fingerprintOf(first));
    }

    void scriptsGoThroughPipes() {
        const QTemporaryDir folder;
        const QString script = folder.filePath(QStringLiteral("shots.json"));
        const QStringList random{"--random", "3", "--seed", "5"};
        const CliRun filed = shoot(random + QStringList{"--save", script});
        QFile file(script);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const CliRun piped = shoot(random + QStringList{"--save", "-"});
        QVERIFY2(piped.status == 0, qPrintable(piped.err));
        QCOMPARE(piped.out.toUtf8(), file.readAll());
        QVERIFY(!QFile::exists(QStringLiteral("-")));
    }

    void optionsThatHaveNoEffectTogetherAreRefused_data() {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QString>("says");
        QTest::newRow("two flights") << QStringList{"--instant", "--flight", "paper"} << "exclude each other";
        QTest::newRow("a cone of random shots") << QStringList{"--random", "2", "--cone", "3"} << "--burst";
        QTest::newRow("a spread of nothing") << QStringList{"--size-spread", "5"} << "--scatter";
    }
    void optionsThatHaveNoEffectTogetherAreRefused() {
        QFETCH(const QStringList, options);
        QFETCH(const QString, says);
        const CliRun run = shoot(options);
        QCOMPARE(run.status, 2);
        QVERIFY2(run.err.contains(says), qPrintable(run.err));
    }

    void errorsInScriptsNameTheFile() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("empty.json"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("{}") == 2);
        file.close();
        const CliRun run = shoot({"--script", path});
        QCOMPARE(run.status, 3);
        QVERIFY2(run.err.contains(path), qPrintable(run.err));
    }

    // The mesh is the reference's, and the same options make it again, from hits that were saved, too.
    void formsOfDents_data() {
        QTest::addColumn<QStringList>("options");
        QTest::newRow("smooth") << QStringList{"--profile", "smooth"};
        QTest::newRow("wendland") << QStringList{"--profile", "wendland"};
        QTest::newRow("linear") << QStringList{"--profile", "linear", "--dent-direction", "surface"};
        QTest::newRow("crater") << QStringList{"--profile", "crater"};
        QTest::newRow("curve") << QStringList{"--curve", "1,0.5,0.75,0.5,-0.25,-0.1,0.1,0"};
        QTest::newRow("press") << QStringList{"--dent-direction", "press"};
    }
    void formsOfDents() {
        QFETCH(const QStringList, options);
        const QTemporaryDir folder;
        const QString hits = folder.filePath(QStringLiteral("hits.csv"));
        const QStringList burst{"--burst", "20", "--cone", "3", "--instant"};
        const CliRun paper = shoot(burst);
        const CliRun run = shoot(burst + options + QStringList{"--hits-out", hits});
        QVERIFY2(run.status == 0, qPrintable(run.err));
        QVERIFY2(!run.out.contains(QStringLiteral("differ")), qPrintable(run.out));
        QVERIFY(fingerprintOf(run) != fingerprintOf(paper));
        QCOMPARE(fingerprintOf(shoot({"--hits", hits})), fingerprintOf(run));
        const QString script = folder.filePath(QStringLiteral("shots.json"));
        QCOMPARE(fingerprintOf(shoot(burst + options + QStringList{"--save", script})), fingerprintOf(run));
        QCOMPARE(fingerprintOf(shoot({"--script", script})), fingerprintOf(run));
    }

    /// What of the dents' form is not given is the session's.
    void keepsTheFormOfTheSession() {
        const QTemporaryDir folder;
        const QString first = folder.filePath(QStringLiteral("first.hitscope"));
        const QStringList few{"--burst", "3", "--seed", "4", "--instant"};
        QCOMPARE(
            shoot(QStringList{"--profile", "smooth", "--dent-direction", "surface", "--session", first} + few)
                .status,
            0);
        const auto formOfLast = [&](const QStringList& options) {
            const QString hits = folder.filePath(QStringLiteral("hits.csv"));
            const CliRun run = shoot(options + few + QStringList{"--hits-out", hits, first});
            QFile file(hits);
            if (run.status != 0 || !file.open(QIODevice::ReadOnly)) {
                return QByteArray("did not run: ") + run.err.toUtf8();
            }
            return file.readAll().trimmed().split('\n').last();
        };
        const QByteArray kept = formOfLast({});
        QVERIFY2(kept.contains("smooth") && kept.contains("surface"), kept.constData());
        const QByteArray other = formOfLast({"--profile", "crater"});
        QVERIFY2(other.contains("crater") && other.contains("surface"), other.constData());
        const QByteArray along = formOfLast({"--dent-direction", "projectile"});
        QVERIFY2(along.contains("smooth") && !along.contains("surface"), along.constData());
        const QByteArray pressed = formOfLast({"--dent-direction", "press"});
        QVERIFY2(pressed.contains("press") && !pressed.contains("smooth"), pressed.constData());
    }

    void refinesBeforeItShoots() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("box.obj"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(
            "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv 0 0 -1\nf 1 2 3 4\nf 2 1 5\nf 3 2 5\nf 4 3 5\nf 1 4 "
            "5\n");
        file.close();
        const QString out = folder.filePath(QStringLiteral("fine.ply"));
        const QStringList few{"--burst", "2", "--cone", "1", "--instant", path};
        const CliRun run = shoot(QStringList{"--refine", "0.1", "--out", out} + few);
        QVERIFY2(run.status == 0, qPrintable(run.err));
        QFile written(out);
        QVERIFY(written.open(QIODevice::ReadOnly));
        const QByteArray bytes = written.readAll();
        QVERIFY(bytes.contains("property uchar new\n"));
        QVERIFY(bytes.contains("property int source_vertex\n"));
        QCOMPARE(shoot(QStringList{"--refine", "0.1"} + few).status, 0);
        QVERIFY(fingerprintOf(run) != fingerprintOf(shoot(few)));
        std::set<QString> fingerprints{fingerprintOf(run)};
        for (const char* method : {"midpoint", "longest-edge", "butterfly"}) {
            const CliRun by =
                shoot(QStringList{"--refine", "0.1", "--refine-by", QLatin1String(method)} + few);
            QVERIFY2(by.status == 0, qPrintable(by.err));
            fingerprints.insert(fingerprintOf(by));
        }
        QCOMPARE(fingerprints.size(), std::size_t{3});  // midpoint is what is done unless asked otherwise
        QCOMPARE(shoot(QStringList{"--refine-by", "butterfly"} + few).status, 2);
        for (const char* wrong : {"0", "-1", "x"}) {
            QVERIFY(shoot(QStringList{"--refine", QLatin1String(wrong)} + few).status != 0);
        }
    }

    void separatesObjectsBeforeItShoots() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("two.obj"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(
            "o near\nv -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n"
            "o far\nv -1 -1 -9\nv 1 -1 -9\nv 0 1 -9\nf 4 5 6\n");
        file.close();
        const QString out = folder.filePath(QStringLiteral("near.ply"));
        const QStringList few{"--separate", "--at", "-0.9,-0.97,0", "--instant", "--out", out, path};
        const CliRun run = shoot(few);
        QVERIFY2(run.status == 0, qPrintable(run.err + run.out));
        QFile written(out);
        QVERIFY(written.open(QIODevice::ReadOnly));
        QVERIFY(written.readAll().contains("element vertex 3\n"));
    }

    /// A tower along z stands, and is still written as it lay.
    void meshesWithZUpAreTurnedUpright() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("tower.obj"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(
            "v -1 -1 0\nv 1 -1 0\nv -1 1 0\nv 1 1 0\nv -1 -1 8\nv 1 -1 8\nv -1 1 8\nv 1 1 8\n"
            "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n");
        file.close();
        const QString out = folder.filePath(QStringLiteral("hit.obj"));
        const QStringList atItsTop{"--at", "0.8,6.8,4", "--out", out, "--max-distance", "5", path};
        QVERIFY(shoot(atItsTop).out.startsWith(QStringLiteral("1 shot, 0 hits")));
        const CliRun run = shoot(QStringList{"--up", "z"} + atItsTop);
        QVERIFY2(run.out.startsWith(QStringLiteral("1 shot, 1 hit")), qPrintable(run.out + run.err));
        QFile written(out);
        QVERIFY(written.open(QIODevice::ReadOnly));
        const QByteArray text = written.readAll();
        QVERIFY2(text.contains("v -1 -1 0\n") && !text.contains("v 1 -1 8\n"), text.constData());
        const CliRun refused = shoot({"--up", "x", path});
        QCOMPARE(refused.status, 2);
    }

    void meshesOfAnySizeAreHit() {
        const QTemporaryDir folder;
        for (const char* extent : {"0.00005", "50000"}) {
            const QString path = folder.filePath(QStringLiteral("box.obj"));
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly));
            for (int corner = 0; corner < 8; ++corner) {
                const auto at = [&](int axis) {
                    return QByteArray((corner >> axis & 1) != 0 ? " " : " -") + extent;
                };
                file.write("v" + at(0) + at(1) + at(2) + "\n");
            }
            file.write("f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n");
            file.close();
            for (const char* flight : {"quick", "instant"}) {
                const CliRun run = shoot({"--burst", "5", "--cone", "2", "--flight", flight, path});
                QVERIFY2(run.out.startsWith(QStringLiteral("5 shots, 5 hits")),
                         qPrintable(run.out + run.err));
            }
            QVERIFY(shoot({"--burst", "5", "--cone", "2", path})
                        .out.startsWith(QStringLiteral("5 shots, 5 hits")));
            QVERIFY(shoot({"--burst", "5", "--cone", "2", "--flight", "paper", path})
                        .out.startsWith(QStringLiteral("5 shots, 0 hits")) ||
                    QByteArray(extent) != "50000");
        }
    }

    // A session of a mesh far from the origin, and of one of any size, opens again and is exported.
    void sessionsOfMeshesAnywhereOpenAgain_data() {
        QTest::addColumn<double>("place");
        QTest::addColumn<double>("extent");
        QTest::newRow("a thousand kilometres away") << 1.0e6 << 5.0;
        QTest::newRow("further than floats tell metres") << 1.0e9 << 5.0;
        QTest::newRow("a thousand kilometres across") << 0.0 << 1.0e6;
        QTest::newRow("a tenth of a micrometre") << 0.0 << 1.0e-7;
        QTest::newRow("larger than any world") << 1.0e30 << 1.0e30;
        QTest::newRow("as large as floats go") << 0.0 << 3.4e38;
        QTest::newRow("smaller than an atom") << 0.0 << 1.0e-30;
        QTest::newRow("smaller than floats go") << 0.0 << 1.0e-100;
    }
    void sessionsOfMeshesAnywhereOpenAgain() {
        QFETCH(const double, place);
        QFETCH(const double, extent);
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("box.obj"));
        const QString session = folder.filePath(QStringLiteral("box.hitscope"));
        const QString written = folder.filePath(QStringLiteral("again.obj"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        for (int corner = 0; corner < 8; ++corner) {
            const auto at = [&](int axis) {
                return " " + QByteArray::number(place + ((corner >> axis & 1) != 0 ? extent : 0.0), 'g', 17);
            };
            file.write("v" + at(0) + at(1) + at(2) + "\n");
        }
        file.write("f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n");
        file.close();
        const CliRun shot = shoot({"--random", "3", "--session", session, path});
        QVERIFY2(shot.status == 0, qPrintable(shot.err));
        QVERIFY2(shot.out.startsWith(QStringLiteral("3 shots, 3 hits")), qPrintable(shot.out));
        const CliRun again = runCli({"export", "--check", "--out", written, session});
        QVERIFY2(again.status == 0, qPrintable(again.err));
        const CliRun replayed = runCli({"replay", session});
        QVERIFY2(replayed.status == 0, qPrintable(replayed.out + replayed.err));
        QCOMPARE(fingerprintOf(replayed), fingerprintOf(shot));
    }

    void scatteredAndMirroredHitsAreTheSameAgain() {
        const QTemporaryDir folder;
        const QString hits = folder.filePath(QStringLiteral("hits.csv"));
        const QStringList scatter{"--scatter", "50", "--seed", "4", "--size-spread", "30"};
        const CliRun first = shoot(scatter + QStringList{"--hits-out", hits});
        QVERIFY2(first.status == 0, qPrintable(first.err));
        QVERIFY2(first.out.startsWith(QStringLiteral("0 shots, 50 hits")), qPrintable(first.out));
        QCOMPARE(shoot(scatter).out + QStringLiteral("In %1: the hits\n").arg(hits), first.out);
        QVERIFY(fingerprintOf(shoot({"--scatter", "50", "--seed", "5", "--size-spread", "30"})) !=
                fingerprintOf(first));
        QFile file(hits);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll().count("scatter 1"), 50);
        const QString craters = folder.filePath(QStringLiteral("craters.csv"));
        QCOMPARE(shoot(scatter + QStringList{"--profile", "crater", "--hits-out", craters}).status, 0);
        QFile formed(craters);
        QVERIFY(formed.open(QIODevice::ReadOnly));
        QCOMPARE(formed.readAll().count("crater"), 50);
        const CliRun both = shoot({"--hits", hits, "--mirror", "x"});
        QVERIFY2(both.out.startsWith(QStringLiteral("0 shots, 100 hits")), qPrintable(both.out + both.err));
    }

    /// Wide and deep dents bring a coarse ball below the floor, where no more shots get to it.
    void shotsThatFindNoPlaceAreNoted() {
        const QTemporaryDir folder;
        const QString mesh = writeBytes(folder.filePath(QStringLiteral("coarse.obj")), ballObj(6, 8));
        const QStringList deep{"--random",       "400", "--max-magnitude", "1",
                               "--max-distance", "3",   "--json",          mesh};
        const CliRun run = shoot(deep);
        QVERIFY2(run.status == 0, qPrintable(run.err));
        const QJsonObject report = QJsonDocument::fromJson(run.out.toUtf8()).object();
        const int shots = report["shots"].toInt();
        QCOMPARE(report["requested"].toInt(), 400);
        QVERIFY2(shots > 0 && shots < 400, qPrintable(run.out));
        QVERIFY2(run.err.contains(QStringLiteral("only %1 of 400 shots").arg(shots)), qPrintable(run.err));
        QCOMPARE(shoot(deep).out, run.out);
        // Those that are found are the same, however many are asked for.
        const CliRun fewer = shoot({"--random", QString::number(shots), "--max-magnitude", "1",
                                    "--max-distance", "3", "--json", mesh});
        QCOMPARE(QJsonDocument::fromJson(fewer.out.toUtf8()).object()["positions_fingerprint"],
                 report["positions_fingerprint"]);
    }

    /// A refined picture is not the plain one, and not larger.
    void picturesAreRefined() {
        const QTemporaryDir folder;
        const auto draw = [&folder](const QStringList& options) {
            const QString file = folder.filePath(QStringLiteral("shot.png"));
            const CliRun run = shoot(QStringList{"--burst", "3", "--picture", file} + options);
            return run.status == 0 ? QImage(file) : QImage();
        };
        const QImage plain = draw({});
        QCOMPARE(plain.size(), QSize(1280, 720));
        QCOMPARE(draw({"--samples", "1"}), plain);
        const QImage refined = draw({"--samples", "4"});
        QCOMPARE(refined.size(), plain.size());
        QVERIFY(refined != plain);
    }

    /// A ball of 1 mm fills the picture as one of 2 m does.
    void picturesShowMeshesOfAnySize() {
        const QTemporaryDir folder;
        const auto draw = [&folder](double scale) {
            QByteArray text;
            for (const QByteArray& line : ballObj().split('\n')) {
                QByteArrayList words = line.split(' ');
                for (qsizetype i = 1; words[0] == "v" && i < words.size(); ++i) {
                    words[i] = QByteArray::number(scale * words[i].toDouble(), 'g', 9);
                }
                text += words.join(' ') + '\n';
            }
            const QString mesh = writeBytes(folder.filePath(QStringLiteral("ball.obj")), text);
            const QString file = folder.filePath(QStringLiteral("shot.png"));
            const CliRun run = shoot({"--burst", "3", "--picture", file, mesh});
            return run.status == 0 ? QImage(file) : QImage();
        };
        const QImage large = draw(1.0);
        const QImage small = draw(0.0005);
        QCOMPARE(small.size(), QSize(1280, 720));
        qint64 off = 0;
        for (int y = 0; y < small.height(); y += 4) {
            for (int x = 0; x < small.width(); x += 4) {
                off += std::abs(qGray(small.pixel(x, y)) - qGray(large.pixel(x, y))) > 24 ? 1 : 0;
            }
        }
        QVERIFY2(off < 320 * 180 / 20, qPrintable(QString::number(off)));
    }

    void wrongUsageIsSaid() {
        QCOMPARE(shoot({"--samples", "4"}).status, 2);
        QCOMPARE(shoot({"--samples", "65", "--picture", "a.png"}).status, 2);
        QCOMPARE(shoot({"--scatter", "0"}).status, 2);
        QCOMPARE(shoot({"--scatter", "3", "--density", "2"}).status, 2);
        QCOMPARE(shoot({"--mirror", "w"}).status, 2);
        QCOMPARE(shoot({"--flight", "slow"}).status, 2);
        QCOMPARE(shoot({"--burst", "0"}).status, 2);
        QCOMPARE(shoot({"--cone", "400"}).status, 2);
        QCOMPARE(shoot({"--profile", "paprika"}).status, 2);
        QCOMPARE(shoot({"--dent-direction", "up"}).status, 2);
        QCOMPARE(shoot({"--curve", "1,2,3"}).status, 2);
        QCOMPARE(shoot({"--dent-direction", "press", "--profile", "linear"}).status, 2);
        QCOMPARE(shoot({"--script", "a", "--burst", "3"}).status, 2);
        const CliRun missing = shoot({"--script", "/nowhere/shots.json"});
        QCOMPARE(missing.status, 3);
        QVERIFY(missing.err.contains(QStringLiteral("/nowhere/shots.json")));
    }
};

HITSCOPE_TEST(ShootTest, QCoreApplication)

}  // namespace hitscope::shoot_test

#include "shoot_test.moc"
