// SPDX-License-Identifier: GPL-3.0-or-later
// Each verb of hitscope-cli with good and bad input, as tables; what it says as JSON is as its schema has it.
#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <numeric>

#include "cli/run_cli.h"
#include "cli/scene_files.h"
#include "support/test_program.h"

namespace hitscope::verbs_test {

using namespace test;

namespace {

QStringList wordsOf(const QString& line) {
    return line.split(u' ', Qt::SkipEmptyParts);
}

QJsonObject jsonOf(const CliRun& run) {
    return QJsonDocument::fromJson(run.out.toUtf8()).object();
}

}  // namespace

class VerbsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void good_data();
    void good();
    void bad_data();
    void bad();
    void reportsAreAsTheirSchemas_data();
    void reportsAreAsTheirSchemas();
    void randomShotsHit();
    void shotsAtAPlaceHitIt();
    void savedShotsHitTheSame();
    void changesReadBackToTheSameBits();
    void explanationsAddUp();
    void dentsAreMeasured();
    void comparisonsHoldTolerances();
    void sectionsAreDrawn();
    void standardStreams();
    void quietSaysNothing();

private:
    [[nodiscard]] CliRun run(const QString& line) const;
    [[nodiscard]] QString in(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    QTemporaryDir m_folder;
};

/// A line in the tests' folder; @ stands for it.
CliRun VerbsTest::run(const QString& line) const {
    QStringList arguments = wordsOf(line);
    for (QString& argument : arguments) {
        argument.replace(u'@', m_folder.path() + u'/');
    }
    return runCli(arguments);
}

void VerbsTest::initTestCase() {
    writeBytes(in("ball.obj"), ballObj());
    writeBytes(in("other.obj"), ballObj(10, 12));
    writeBytes(in("bad.obj"), "v 0 0 0\nf 1 2 3\n");
    writeBytes(in("bad.hitscope"), "{\"format\": 3}");
    writeBytes(in("bad.json"), "{");
    writeBytes(in("plan.json"),
               "{\"hitscope-sweep\": 1, \"scenes\": [\"ball.obj\"], \"options\": {\"random\": 3, \"seed\": "
               "[1, 2]}}");
    const CliRun made =
        run("shoot --pipeline reference --at 0,0,0 --direction 0,-1,0 --session @one.hitscope @ball.obj");
    QVERIFY2(made.status == 0, qPrintable(made.err));
    const CliRun more =
        run("shoot --pipeline reference --random 6 --seed 2 --max-distance 0.8 --session @many.hitscope "
            "--hits-out @hits.csv --out @many.ply --picture @many.png --save @shots.json @ball.obj");
    QVERIFY2(more.status == 0, qPrintable(more.err));
}

void VerbsTest::good_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* line, const char* says) {
        QTest::newRow(line) << QString::fromLatin1(line) << QString::fromUtf8(says);
    };
    row("info @ball.obj @other.obj", "other.obj");
    row("info @many.hitscope", "Deformed");
    row("info --renderer", "OpenGL");
    row("shoot --burst 3 --cone 1 @ball.obj", "3 shots, 3 hits");
    row("shoot --hits @hits.csv @ball.obj", "0 shots, 6 hits");
    row("shoot --at 0,0,0 --speed 50 --radius 0.05 --flight quick @one.hitscope", "1 hit; 2 hits in all");
    row("replay @many.hitscope", "the positions are those that were saved");
    row("replay --until 2 @many.hitscope", "2 of 6 hits");
    row("verify @many.hitscope", "6 hits");
    row("export --out @out.glb @many.hitscope", "out.glb: ball");
    row("export --steps 5 --step-of group --check --out @groups.glb @many.hitscope", "groups.glb: ball");
    row("export --all --world --check --out @all.ply @many.hitscope", "all.ply");
    row("export --format csv --out - @one.hitscope", "displacement");
    row("convert @ball.obj @ball.stl", "ball.stl");
    row("convert --format ply-ascii @ball.obj -", "element vertex 362");
    row("compare @ball.obj @ball.obj", "0 of 362 vertices differ");
    row("compare --with reference --tolerance 100 @many.hitscope", "of 362 vertices differ");
    row("changes @one.hitscope", "normal_turned_deg,hits,new");
    row("explain --vertex 1 @one.hitscope", "hit 1");
    row("explain --vertex 2 @one.hitscope", "original");
    row("dents @one.hitscope", "dent 1, hit 1");
    row("section --plane z=0 @many.hitscope", "Greatest depth");
    row("section --plane z=5 @ball.obj", "Offset");
    row("picture --size 64x48 --ghost wire --wipe 0.5 --flat --dots @a.png @many.hitscope", "");
    row("picture --size 64x48 --change hits --colour-map cividis --range 0,3 --isolines @a.png "
        "@many.hitscope",
        "");
    row("sequence --replay --size 32x24 @frames @one.hitscope", "2 pictures");
    row("sweep --list --out @swept @plan.json", "--seed=2");
    row("sweep --slurm --out @swept @plan.json", "#SBATCH --array=0-1");
    row("sweep --snakemake --out @swept @plan.json", "rule all:");
    row("help", "Verbs:");
    row("help shoot", "--random=N");
    row("help --man --program hitscope", ".TH HITSCOPE 1");
    row("help --completion fish", "complete -c hitscope-cli");
}

void VerbsTest::good() {
    QFETCH(QString, line);
    QFETCH(QString, says);
    const CliRun made = run(line);
    QVERIFY2(made.status == 0, qPrintable(made.err));
    QVERIFY2(made.out.contains(says), qPrintable(made.out));
}

void VerbsTest::bad_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<int>("status");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* line, int status, const char* says) {
        QTest::newRow(line) << QString::fromLatin1(line) << status << QString::fromUtf8(says);
    };
    row("info", 2, "--renderer");
    row("info --renderer @ball.obj", 2, "--renderer");
    row("info @bad.obj", 3, "bad.obj");
    row("info @bad.hitscope", 3, "bad.hitscope, line 1");
    row("shoot --random 0 @ball.obj", 2, "--random takes");
    row("shoot --random 3 --at 0,0,0 @ball.obj", 2, "exclude each other");
    row("shoot --direction 0,1,0 @ball.obj", 2, "--at");
    row("shoot --at 0,0,0 --direction 0,0,0 @ball.obj", 2, "--direction takes");
    row("shoot --max-distance -1 @ball.obj", 2, "--max-distance takes");
    row("shoot @ball.obj @other.obj", 2, "one file at most");
    row("shoot --hits @bad.json @ball.obj", 3, "bad.json");
    row("shoot --picture @a.xyz @ball.obj", 2, ".png");
    row("shoot --session @no/such/folder.hitscope @ball.obj", 3, "folder.hitscope");
    row("shoot --random 1 --out @a.hitscope @ball.obj", 2, "--out writes a mesh");
    row("replay --out @a.xyz @one.hitscope", 2, ".glb");
    row("replay @ball.obj", 2, "session");
    row("replay --until 9 @one.hitscope", 3, "--until");
    row("replay @none.hitscope", 3, "none.hitscope");
    row("verify @ball.obj", 2, "--hits");
    row("export @one.hitscope", 2, "--out");
    row("export --out @a.xyz @one.hitscope", 2, "--format");
    row("export --out - --format gltf @one.hitscope", 2, "glb");
    row("export --step-of group --out @a.glb @one.hitscope", 2, "--steps");
    row("export --target Moon --out @a.obj @one.hitscope", 3, "There are: ball.");
    row("export --all --target ball --out @a.obj @one.hitscope", 2, "exclude");
    row("convert @ball.obj", 2, "2 files");
    row("convert @one.hitscope @a.obj", 2, "export");
    row("convert @bad.obj @a.ply", 3, "bad.obj");
    row("compare @ball.obj", 2, "--with");
    row("compare --with magic @one.hitscope", 2, "--with takes");
    row("compare @ball.obj @other.obj", 3, "same topology");
    row("compare @ball.obj @many.ply", 1, "differ");
    row("compare @one.hitscope @many.hitscope", 1, "differ");
    row("compare --map @a.xyz @ball.obj @ball.obj", 2, ".png");
    row("changes @ball.obj", 2, "session");
    row("changes --target Moon @one.hitscope", 3, "Moon");
    row("explain @one.hitscope", 2, "explain needs --vertex");
    row("explain --vertex 9999 @one.hitscope", 3, "362 vertices");
    row("dents @ball.obj", 2, "session");
    row("section @one.hitscope", 2, "--plane");
    row("section --plane w=1 @one.hitscope", 2, "--plane takes");
    row("picture --until 1 @a.png @ball.obj", 2, "--until");
    row("picture --range 3,1 @a.png @one.hitscope", 2, "--range takes");
    row("sequence --turntable 2 --size 20000x10 @a.mp4 @ball.obj", 4, "16384");
    row("sweep", 2, "PLAN");
    row("sweep --list --merge @plan.json", 2, "exclude");
    row("sweep --out @swept @bad.json", 3, "bad.json");
    row("sweep --out @swept @none.json", 3, "none.json");
    row("sweep --merge --out @nothing @plan.json", 3, "2 jobs have no result");
    row("help fly", 2, "fly");
    row("help --completion tcsh", 2, "bash, zsh, fish");
}

void VerbsTest::bad() {
    QFETCH(QString, line);
    QFETCH(int, status);
    QFETCH(QString, says);
    const CliRun made = run(line);
    QVERIFY2(made.status == status, qPrintable(QString::number(made.status) + u'\n' + made.err));
    QVERIFY2(made.err.contains(says), qPrintable(made.err));
    QCOMPARE(made.err.count(u'\n'), status == 2 ? 2 : 1);
}

void VerbsTest::reportsAreAsTheirSchemas_data() {
    QTest::addColumn<QString>("line");
    for (const char* line :
         {"info --json @ball.obj", "info --json @many.hitscope", "info --json --renderer",
          "shoot --json @ball.obj", "shoot --json", "replay --json @many.hitscope",
          "verify --json @many.hitscope", "export --json --out @x.obj @many.hitscope",
          "convert --json @ball.obj @x.ply", "compare --json --tolerance 9 @ball.obj @many.ply",
          "changes --json @many.hitscope", "explain --json --vertex 1 @many.hitscope",
          "dents --json @many.hitscope", "section --json --plane x=0 @many.hitscope",
          "sweep --json --out @schema @plan.json", "demo --json --shots 5 --out @demo @ball.obj"}) {
        QTest::newRow(line) << QString::fromLatin1(line);
    }
}

void VerbsTest::reportsAreAsTheirSchemas() {
    QFETCH(QString, line);
    const CliRun made = run(line);
    QVERIFY2(made.status == 0, qPrintable(made.err));
    const QString verb = wordsOf(line).constFirst();
    QCOMPARE(jsonOf(made)["report"].toString(), verb);
    const QString file = writeBytes(in("report.json"), made.out.toUtf8());
    QProcess python;
    python.setProcessChannelMode(QProcess::MergedChannels);
    const QString check = QStringLiteral(
        "import json, sys\ntry:\n    import jsonschema\nexcept ImportError:\n    sys.exit(77)\n"
        "jsonschema.validate(json.load(open(sys.argv[1])), json.load(open(sys.argv[2])))");
    python.start(QStringLiteral("python3"),
                 {"-c", check, file,
                  QStringLiteral(HITSCOPE_SHADERS "/../resources/schemas/cli/%1.schema.json").arg(verb)});
    QVERIFY(python.waitForFinished(60'000));
    if (python.exitCode() == 77) {
        QSKIP("Python's package jsonschema is not here.");
    }
    QVERIFY2(python.exitCode() == 0, python.readAll().right(2000).constData());
}

/// Each is aimed at what the ones before have left.
void VerbsTest::randomShotsHit() {
    for (const char* line :
         {"shoot --json --random 60 --seed 5 @ball.obj", "shoot --json --random 60 --instant @ball.obj",
          "shoot --json --random 40 --seed 9 --max-distance 2 @other.obj"}) {
        const CliRun made = run(QString::fromLatin1(line));
        QVERIFY2(made.status == 0, qPrintable(made.err));
        QCOMPARE(jsonOf(made)["hits"].toInt(), jsonOf(made)["shots"].toInt());
        QVERIFY(jsonOf(made)["shots"].toInt() >= 40);
    }
    const QString once = run("shoot --random 20 --seed 5 @ball.obj").out;
    QCOMPARE(run("shoot --random 20 --seed 5 @ball.obj").out, once);
    QVERIFY(run("shoot --random 20 --seed 6 @ball.obj").out != once);
}

void VerbsTest::shotsAtAPlaceHitIt() {
    const CliRun made =
        run("shoot --at 0,0,0 --direction 0,-1,0 --hits-out - --quiet --report @r.json @ball.obj");
    QVERIFY2(made.status == 0, qPrintable(made.err));
    const QStringList lines = made.out.trimmed().split(u'\n');
    QCOMPARE(lines.size(), 2);
    const qsizetype column = lines[0].split(u',').indexOf(QStringLiteral("point_y_m"));
    QVERIFY2(column >= 0, qPrintable(lines[0]));
    QVERIFY(std::abs(lines[1].split(u',')[column].toDouble() - 1.0) < 1.0e-5);  // the pole, from above
}

void VerbsTest::savedShotsHitTheSame() {
    const CliRun script =
        run("shoot --json --max-distance 0.8 --script @shots.json --pipeline reference @ball.obj");
    QVERIFY2(script.status == 0, qPrintable(script.err));
    const CliRun replayed = run("replay --json @many.hitscope");
    QCOMPARE(jsonOf(script)["positions_fingerprint"], jsonOf(replayed)["positions_fingerprint"]);
    QCOMPARE(jsonOf(run("shoot --json --hits @hits.csv @ball.obj"))["positions_fingerprint"],
             jsonOf(replayed)["positions_fingerprint"]);
}

void VerbsTest::changesReadBackToTheSameBits() {
    const QStringList rows = run("changes @many.hitscope").out.trimmed().split(u'\n');
    const QJsonArray vertices =
        jsonOf(run("changes --json @many.hitscope"))["targets"].toArray()[0].toObject()["vertices"].toArray();
    QVERIFY(vertices.size() > 10);
    QCOMPARE(rows.size(), vertices.size() + 1);
    for (qsizetype i = 0; i < vertices.size(); ++i) {
        const QStringList cells = rows[i + 1].split(u',');
        const QJsonObject vertex = vertices[i].toObject();
        QCOMPARE(vertex["vertex"].toInt(), cells[1].toInt());
        for (int axis = 0; axis < 3; ++axis) {
            const float original = cells[2 + axis].toFloat();
            const float current = cells[5 + axis].toFloat();
            QCOMPARE(static_cast<float>(vertex["original_m"].toArray()[axis].toDouble()), original);
            QCOMPARE(static_cast<float>(vertex["current_m"].toArray()[axis].toDouble()), current);
            QCOMPARE(cells[8 + axis].toFloat(), current - original);
        }
    }
}

void VerbsTest::explanationsAddUp() {
    const QJsonArray vertices =
        jsonOf(run("changes --json @many.hitscope"))["targets"].toArray()[0].toObject()["vertices"].toArray();
    const QJsonObject changed = vertices[0].toObject();
    const CliRun made =
        run(QStringLiteral("explain --json @many.hitscope --vertex %1").arg(changed["vertex"].toInt()));
    QVERIFY2(made.status == 0, qPrintable(made.err));
    const QJsonObject why = jsonOf(made);
    QCOMPARE(why["hits"].toArray().size(), changed["hits"].toInt());
    for (int axis = 0; axis < 3; ++axis) {  // a float there, and all digits of it here
        QCOMPARE(static_cast<float>(changed["current_m"].toArray()[axis].toDouble()),
                 static_cast<float>(why["current_m"].toArray()[axis].toDouble()));
    }
    QCOMPARE(why["hits"].toArray().last().toObject()["position_m"], why["current_m"]);
}

void VerbsTest::dentsAreMeasured() {
    const QJsonArray dents =
        jsonOf(run("dents --json @one.hitscope"))["targets"].toArray()[0].toObject()["dents"].toArray();
    QCOMPARE(dents.size(), 1);
    const QJsonObject dent = dents[0].toObject();
    QCOMPARE(dent["hits"].toArray(), QJsonArray{1});
    QCOMPARE(dent["deepest_vertex"].toInt(), 1);  // the pole
    // max_magnitude of a target 2 m across: 0.3 m for one of 5 m.
    QVERIFY(std::abs(dent["depth_m"].toDouble() - 0.12) < 1.0e-4);
    QVERIFY(dent["displaced_volume_m3"].toDouble() > 0.0);
    // Overlapping ones are told apart, each vertex belongs to one, and each hit to one at most.
    const auto dentsOf = [this](const QString& command) {
        return jsonOf(run(command))["targets"].toArray()[0].toObject()["dents"].toArray();
    };
    const QJsonArray apart = dentsOf("dents --json @many.hitscope");
    const QJsonArray merged = dentsOf("dents --json --merged @many.hitscope");
    QVERIFY2(apart.size() > merged.size(), qPrintable(QString::number(merged.size())));
    for (const char* const key : {"vertices", "affected_area_m2", "displaced_volume_m3"}) {
        const auto sumOf = [key](const QJsonArray& all) {
            return std::accumulate(all.begin(), all.end(), 0.0, [key](double sum, const QJsonValue& one) {
                return sum + one.toObject()[QLatin1String(key)].toDouble();
            });
        };
        QVERIFY(std::abs(sumOf(apart) / sumOf(merged) - 1.0) < 1.0e-9);
    }
    QSet<int> seen;
    for (const QJsonValue& one : apart) {
        for (const QJsonValue& hit : one.toObject()["hits"].toArray()) {
            QVERIFY(!seen.contains(hit.toInt()));
            seen.insert(hit.toInt());
        }
    }
}

void VerbsTest::comparisonsHoldTolerances() {
    const CliRun past = run("compare --json --tolerance 0.05 --map @map.png @one.hitscope @ball.obj");
    QCOMPARE(past.status, 1);
    QVERIFY(QFileInfo(in("map.png")).size() > 1000);
    const QJsonObject target = jsonOf(past)["targets"].toArray()[0].toObject();
    QVERIFY(std::abs(target["largest_m"].toDouble() - 0.12) < 1.0e-4);
    QCOMPARE(target["vertex"].toInt(), 1);
    QVERIFY(target["rms_m"].toDouble() > 0.0 && target["rms_m"].toDouble() < target["largest_m"].toDouble());
    QCOMPARE(run("compare --tolerance 0.13 @one.hitscope @ball.obj").status, 0);
}

void VerbsTest::sectionsAreDrawn() {
    const CliRun made = run("section --plane z=0 --csv @s.csv --svg - @one.hitscope");
    QVERIFY2(made.status == 0, qPrintable(made.err));
    QVERIFY(made.out.startsWith(QStringLiteral("<?xml")) &&
            made.out.contains(QStringLiteral("class=\"deformed\"")));
    QFile csv(in("s.csv"));
    QVERIFY(csv.open(QIODevice::ReadOnly) && csv.readAll().startsWith("state,target,line,"));
}

void VerbsTest::standardStreams() {
    QProcess shell;
    shell.setWorkingDirectory(m_folder.path());
    shell.start(QStringLiteral("bash"),
                {"-c",
                 "\"$HITSCOPE_CLI\" replay - < many.hitscope && "
                 "\"$HITSCOPE_CLI\" shoot --hits - ball.obj < hits.csv | tail -n 1 && "
                 "\"$HITSCOPE_CLI\" shoot --script - --max-distance 0.8 ball.obj < shots.json | tail -n 1 && "
                 "\"$HITSCOPE_CLI\" sweep --list - < plan.json | wc -l"});
    QVERIFY(shell.waitForFinished(100'000));
    const QString out = QString::fromUtf8(shell.readAllStandardOutput());
    QCOMPARE(shell.exitCode(), 0);
    QVERIFY2(out.contains(QStringLiteral("6 of 6 hits")) && out.endsWith(QStringLiteral("\n2\n")),
             qPrintable(out));
}

void VerbsTest::quietSaysNothing() {
    const CliRun loud = run("convert @ball.obj @q.stl");
    const CliRun quiet = run("convert --quiet --report @q.json @ball.obj @q.stl");
    QVERIFY(!loud.out.isEmpty());
    QVERIFY2(quiet.status == 0 && quiet.out.isEmpty() && quiet.err.isEmpty(),
             qPrintable(quiet.out + quiet.err));
    QVERIFY(QFile::exists(in("q.json")));
}

HITSCOPE_TEST(VerbsTest, QCoreApplication)

}  // namespace hitscope::verbs_test

#include "verbs_test.moc"
