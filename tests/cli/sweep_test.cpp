// SPDX-License-Identifier: GPL-3.0-or-later
// A sweep that is interrupted and goes on, and the same sweep run by others.
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>
#include <map>

#include "cli/run_cli.h"
#include "cli/scene_files.h"
#include "support/test_program.h"

namespace hitscope::sweep_test {

using namespace test;

class SweepTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void interruptedItGoesOn();
    void othersMakeTheSameTable_data();
    void othersMakeTheSameTable();
    void jobArraysTakeAnyFolder();
    void anotherContentIsAnotherJob();
    void buffersAreContent_data();
    void buffersAreContent();
    void meshesOfSessionsAreContent();
    void scenesOfOneContentShareAResult();
    void plansAreChecked_data();
    void plansAreChecked();
    void whatFailsIsSaid();

private:
    [[nodiscard]] QString in(const QString& name) const { return m_folder.filePath(name); }
    [[nodiscard]] QByteArray read(const QString& name) const {
        QFile file(in(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    [[nodiscard]] std::map<QString, QDateTime> reports(const QString& folder) const {
        std::map<QString, QDateTime> found;
        for (const QFileInfo& info :
             QDir(in(folder + QStringLiteral("/jobs"))).entryInfoList(QDir::Files | QDir::Hidden)) {
            found[info.fileName()] = info.lastModified();
        }
        return found;
    }
    QTemporaryDir m_folder;
};

void SweepTest::initTestCase() {
    writeBytes(in("ball.obj"), ballObj());
    writeBytes(in("coarse ball.obj"), ballObj(8, 10));
    writeBytes(in("plan.json"),
               "{\"hitscope-sweep\": 1, \"scenes\": [\"ball.obj\", \"coarse ball.obj\"],\n \"options\": "
               "{\"random\": 4, "
               "\"pipeline\": \"reference\", \"max-distance\": [0.3, 0.5], \"seed\": [1, 2, 3]}}");
    // The same jobs first, and more than any machine does while it is waited for the first three.
    QByteArray seeds("1");
    for (int seed = 2; seed <= 500; ++seed) {
        seeds += ", " + QByteArray::number(seed);
    }
    writeBytes(in("long.json"),
               "{\"hitscope-sweep\": 1, \"scenes\": [\"ball.obj\"],\n \"options\": {\"random\": 4, "
               "\"pipeline\": \"reference\", \"max-distance\": 0.3, \"seed\": [" +
                   seeds + "]}}");
}

void SweepTest::interruptedItGoesOn() {
    QProcess process;
    process.start(qEnvironmentVariable("HITSCOPE_CLI"),
                  {"sweep", "--jobs", "1", "--out", in("here"), in("long.json")});
    QTRY_VERIFY_WITH_TIMEOUT(reports("here").size() >= 3 || process.state() == QProcess::NotRunning, 100'000);
    QCOMPARE(process.state(), QProcess::Running);  // else the signal would go to the tests as well
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    QVERIFY(process.waitForFinished(60'000));
    QCOMPARE(process.exitStatus(), QProcess::CrashExit);  // by the signal, as shells see it
    QTest::qWait(500);                                    // what it had started ends with it
    std::map<QString, QDateTime> before = reports("here");
    QVERIFY2(before.size() >= 3 && before.size() < 500, qPrintable(QString::number(before.size())));
    for (const auto& [name, time] : before) {
        QVERIFY2(!name.startsWith(u'.'), qPrintable(name));  // nothing is half written
    }
    const CliRun rest = runCli({"sweep", "--out", in("here"), in("plan.json")});
    QVERIFY2(rest.status == 0, qPrintable(rest.err));
    QVERIFY2(rest.out.startsWith(QStringLiteral("12 of 12 jobs")), qPrintable(rest.out));
    const std::map<QString, QDateTime> after = reports("here");
    QCOMPARE(after.size(), before.size() + 9);  // three of the twelve were there
    for (const auto& [name, time] : before) {
        QCOMPARE(after.at(name), time);  // not again
    }
    const QByteArray table = read("here/table.csv");
    QVERIFY(table.startsWith("job,scene,max-distance,seed,shots,hits,"));
    QCOMPARE(table.count('\n'), 13);
    QVERIFY(read("here/plots.svg").contains("<polyline") && read("here/table.json").contains("\"axes\""));
}

void SweepTest::othersMakeTheSameTable_data() {
    QTest::addColumn<QString>("way");
    QTest::addColumn<QString>("runs");  // what runs the printed text, in a shell
    QTest::newRow("shell") << "--list"
                           << "bash";
    QTest::newRow("parallel") << "--list"
                              << "parallel";
    QTest::newRow("job array")
        << "--slurm"
        << "cat > j.sh && sed -n 's/^#SBATCH --array=0-//p' j.sh | { read -r n; for i in "
           "$(seq 0 \"$n\"); do SLURM_ARRAY_TASK_ID=$i bash j.sh; done; }";
    QTest::newRow("snakemake") << "--snakemake"
                               << "cat > S && snakemake --snakefile S --cores 2 --quiet";
}

void SweepTest::othersMakeTheSameTable() {
    QFETCH(QString, way);
    QFETCH(QString, runs);
    for (const char* program : {"parallel", "snakemake"}) {
        if (runs.contains(QLatin1String(program)) &&
            QStandardPaths::findExecutable(QLatin1String(program)).isEmpty()) {
            QSKIP("It is not installed here.");
        }
    }
    const QString folder = QString::fromLatin1(QTest::currentDataTag()).replace(u' ', u'-');
    QProcess shell;
    shell.setWorkingDirectory(m_folder.path());
    shell.start(
        "bash",
        {"-o", "pipefail", "-c",
         QStringLiteral("\"$HITSCOPE_CLI\" sweep %1 --program \"$HITSCOPE_CLI\" --out %2 plan.json | { %3; }")
             .arg(way, folder, runs)});
    QVERIFY(shell.waitForFinished(300'000));
    QVERIFY2(shell.exitCode() == 0, shell.readAllStandardError().constData());
    const CliRun merged = runCli({"sweep", "--merge", "--out", in(folder), in("plan.json")});
    QVERIFY2(merged.status == 0, qPrintable(merged.err));
    for (const char* name : {"/table.csv", "/table.json", "/plots.svg"}) {
        QCOMPARE(read(folder + QLatin1String(name)), read(QStringLiteral("here") + QLatin1String(name)));
    }
    QVERIFY(runCli({"sweep", "--list", "--out", in(folder), in("plan.json")}).out.isEmpty());
}

/// A space, a quote and a percent sign in a folder's name, as sbatch reads them.
void SweepTest::jobArraysTakeAnyFolder() {
    const CliRun run = runCli({"sweep", "--slurm", "--out", in("a \"b\" 5%"), in("plan.json")});
    QVERIFY2(run.status == 0, qPrintable(run.err));
    const QString line = QStringLiteral("#SBATCH --output=\"%1/a \\\"b\\\" 5%%/slurm-%A_%a.log\"\n");
    QVERIFY2(run.out.contains(QString(line).replace(QStringLiteral("%1"), m_folder.path())),
             qPrintable(run.out.left(300)));
}

void SweepTest::anotherContentIsAnotherJob() {
    writeBytes(in("small.json"),
               "{\"hitscope-sweep\": 1, \"scenes\": [\"m.obj\"], \"options\": {\"random\": 1}}");
    writeBytes(in("m.obj"), ballObj(6, 6));
    const QStringList arguments{"sweep", "--list", in("small.json")};
    const QString first = runCli(arguments).out;
    QCOMPARE(runCli(arguments).out, first);
    writeBytes(in("m.obj"), ballObj(6, 8));
    QVERIFY(runCli(arguments).out != first);
}

/// The JSON of two glTFs is the same, and their buffers are not.
void SweepTest::buffersAreContent_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("mesh");
    const QByteArray second =
        R"({"asset": {"version": "2.0"}, "buffers": [{"uri": "a%20b.bin", "byteLength": 3}]} )";
    const QByteArray first = R"({"buffers": {"all": {"uri": "a%20b.bin", "byteLength": 3}}} )";
    QTest::newRow("text") << "a.gltf" << second;
    QTest::newRow("version 1") << "a.gltf" << first;
    QByteArray header("glTF\2\0\0\0\0\0\0\0\0\0\0\0JSON", 20);
    header[8] = static_cast<char>(header.size() + second.size());
    header[12] = static_cast<char>(second.size());
    QTest::newRow("binary") << "a.glb" << header + second;
}

void SweepTest::buffersAreContent() {
    QFETCH(const QString, name);
    QFETCH(const QByteArray, mesh);
    const QTemporaryDir folder;
    for (const char* scene : {"s1", "s2"}) {
        QVERIFY(QDir(folder.path()).mkdir(QLatin1String(scene)));
        writeBytes(folder.filePath(QLatin1String(scene) + u'/' + name), mesh);
        writeBytes(folder.filePath(QLatin1String(scene) + QStringLiteral("/a b.bin")), scene);
    }
    const QString plan = writeBytes(folder.filePath(QStringLiteral("plan.json")),
                                    "{\"hitscope-sweep\": 1, \"scenes\": [\"s1/" + name.toUtf8() +
                                        "\", \"s2/" + name.toUtf8() + "\"], \"options\": {\"random\": 1}}");
    QCOMPARE(runCli({"sweep", "--list", plan}).out.count(u'\n'), 2);
    writeBytes(folder.filePath(QStringLiteral("s2/a b.bin")), "s1");
    QCOMPARE(runCli({"sweep", "--list", plan}).out.count(u'\n'), 1);
}

/// The session says what its mesh was; what counts is what it is. The folder may be anywhere.
void SweepTest::meshesOfSessionsAreContent() {
    const QTemporaryDir folder;
    const QString from = folder.filePath(QStringLiteral("from"));
    const QString to = folder.filePath(QStringLiteral("to"));
    QVERIFY(QDir().mkdir(from) && QDir().mkdir(to));
    const QByteArray ball = ballObj(6, 6);
    const QString mesh = writeBytes(from + QStringLiteral("/m.obj"), ball);
    const QString session = from + QStringLiteral("/s.hitscope");
    QVERIFY(runCli({"shoot", "--random", "1", "--session", session, mesh}).status == 0);
    QVERIFY(QFile::copy(session, to + QStringLiteral("/s.hitscope")));
    writeBytes(to + QStringLiteral("/m.obj"), ball);
    const auto keyIn = [](const QString& place) {
        const QString plan =
            writeBytes(place + QStringLiteral("/plan.json"),
                       "{\"hitscope-sweep\": 1, \"scenes\": [\"s.hitscope\"], \"options\": {\"random\": 1}}");
        return QRegularExpression(QStringLiteral("jobs/([0-9a-f]{16})\\.json"))
            .match(runCli({"sweep", "--list", plan}).out)
            .captured(1);
    };
    const QString first = keyIn(from);
    QVERIFY(!first.isEmpty());
    QCOMPARE(keyIn(to), first);
    writeBytes(mesh, ballObj(6, 8));
    QVERIFY(keyIn(from) != first);
    QCOMPARE(keyIn(to), first);
    writeBytes(mesh, ball);
    QCOMPARE(keyIn(from), first);
}

void SweepTest::scenesOfOneContentShareAResult() {
    writeBytes(in("one.obj"), ballObj(6, 6));
    writeBytes(in("two.obj"), ballObj(6, 6));
    writeBytes(in("three.off"), ballObj(6, 6));  // the same bytes, which are no mesh there
    const QString plan = writeBytes(in("same.json"),
                                    "{\"hitscope-sweep\": 1, \"scenes\": [\"one.obj\", \"two.obj\"], "
                                    "\"options\": {\"random\": 1, \"seed\": [1, 2]}}");
    QCOMPARE(runCli({"sweep", "--list", "--out", in("same"), plan}).out.count(u'\n'), 2);
    const QString flow = runCli({"sweep", "--snakemake", "--out", in("same"), plan}).out;
    QCOMPARE(flow.count(QStringLiteral("\nrule job_")), 2);
    const CliRun run = runCli({"sweep", "--out", in("same"), plan});
    QVERIFY2(run.status == 0, qPrintable(run.err));
    QVERIFY2(run.out.startsWith(QStringLiteral("4 of 4 jobs have a result")), qPrintable(run.out));
    QCOMPARE(reports("same").size(), std::size_t{2});
    const QList<QByteArray> rows = read("same/table.csv").trimmed().split('\n');
    QCOMPARE(rows.size(), 5);
    for (const int seed : {1, 2}) {
        QCOMPARE(QByteArray(rows[seed]).replace("one.obj", "two.obj"), rows[seed + 2]);
    }
    writeBytes(in("formats.json"),
               "{\"hitscope-sweep\": 1, \"scenes\": [\"one.obj\", \"three.off\"], "
               "\"options\": {\"random\": 1}}");
    QCOMPARE(runCli({"sweep", "--list", "--out", in("formats"), in("formats.json")}).out.count(u'\n'), 2);
}

void SweepTest::plansAreChecked_data() {
    QTest::addColumn<QByteArray>("plan");
    QTest::addColumn<QString>("says");
    QTest::newRow("no object") << QByteArray("[]") << "A plan is a JSON object";
    QTest::newRow("version") << QByteArray("{\"options\": {}}") << "hitscope-sweep";
    QTest::newRow("member") << QByteArray("{\"hitscope-sweep\": 1, \"meshes\": []}") << "meshes";
    QTest::newRow("option") << QByteArray("{\"hitscope-sweep\": 1, \"options\": {\"speeed\": 3}}")
                            << "speeed";
    QTest::newRow("out") << QByteArray("{\"hitscope-sweep\": 1, \"options\": {\"out\": \"a.obj\"}}")
                         << "options, out";
    QTest::newRow("range") << QByteArray("{\"hitscope-sweep\": 1, \"options\": {\"max-distance\": [1, -1]}}")
                           << "--max-distance takes";
    QTest::newRow("twice") << QByteArray("{\"hitscope-sweep\": 1, \"options\": {\"seed\": [1, 1]}}")
                           << "each once";
    QTest::newRow("key twice") << QByteArray(
                                      "{\"hitscope-sweep\": 1,\n\"options\": {\"seed\": 1,\n\"seed\": 2}}")
                               << "line 3, options, seed: It is there twice.";
    QTest::newRow("options twice")
        << QByteArray("{\"hitscope-sweep\": 1, \"options\": {\"seed\": 1}, \"options\": {}}")
        << "line 1, options: It is there twice.";
    QTest::newRow("null") << QByteArray("{\"hitscope-sweep\": 1, \"options\": {\"seed\": null}}")
                          << "options, seed";
    QTest::newRow("no list") << QByteArray("{\"hitscope-sweep\": 1, \"scenes\": 3, \"options\": {}}")
                             << "scenes";
    QTest::newRow("no file") << QByteArray(
                                    "{\"hitscope-sweep\": 1, \"scenes\": [\"no.obj\"], \"options\": {}}")
                             << "no.obj";
}

void SweepTest::plansAreChecked() {
    QFETCH(QByteArray, plan);
    QFETCH(QString, says);
    const CliRun run = runCli({"sweep", "--list", "--out", in("never"), writeBytes(in("wrong.json"), plan)});
    QCOMPARE(run.status, 3);
    QVERIFY2(run.err.contains(says), qPrintable(run.err));
    QVERIFY(!QFileInfo::exists(in("never")));
}

void SweepTest::whatFailsIsSaid() {
    writeBytes(in("broken.obj"), "v 0 0 0\nf 1 2 3\n");
    writeBytes(
        in("mixed.json"),
        "{\"hitscope-sweep\": 1, \"scenes\": [\"broken.obj\", \"ball.obj\"], \"options\": {\"random\": 1}}");
    const CliRun run = runCli({"sweep", "--out", in("mixed"), in("mixed.json")});
    QCOMPARE(run.status, 3);
    QVERIFY2(run.err.contains(QStringLiteral("broken.obj")) &&
                 run.err.contains(QStringLiteral("1 job has no result")),
             qPrintable(run.err));
    QCOMPARE(read("mixed/table.csv").count('\n'), 2);
}

HITSCOPE_TEST(SweepTest, QCoreApplication)

}  // namespace hitscope::sweep_test

#include "sweep_test.moc"
