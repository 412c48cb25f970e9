// SPDX-License-Identifier: GPL-3.0-or-later
// What hitscope-cli writes replaces nothing that it reads.
#include <QDir>
#include <QFile>
#include <QImage>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <map>

#include "cli/run_cli.h"
#include "cli/scene_files.h"
#include "support/test_program.h"

namespace hitscope::outputs_test {

using namespace test;

namespace {

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class OutputsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        QFile mesh(at("mesh.obj"));
        QVERIFY(mesh.open(QIODevice::WriteOnly));
        mesh.write("mtllib my paint.mtl\n");
        writeBytes(at("my paint.mtl"), "newmtl red\nKd 1 0 0\nmap_Kd wood.png\n");
        QImage(2, 2, QImage::Format_RGB32).save(at("wood.png"));
        for (int y = 0; y <= 8; ++y) {
            for (int x = 0; x <= 8; ++x) {
                mesh.write(QStringLiteral("v %1 %2 0\n").arg(0.25 * x).arg(0.25 * y).toLatin1());
            }
        }
        for (int y = 0; y < 8; ++y) {
            for (int x = 0; x < 8; ++x) {
                const int a = y * 9 + x + 1;
                mesh.write(
                    QStringLiteral("f %1 %2 %3 %4\n").arg(a).arg(a + 1).arg(a + 10).arg(a + 9).toLatin1());
            }
        }
        mesh.close();
        const CliRun shot = runCli({"shoot", "--random", "2", "--session", at("s.hitscope"), at("mesh.obj")});
        QVERIFY2(shot.status == 0, qPrintable(shot.err));
        QVERIFY2(shot.out.contains(QStringLiteral("s.hitscope: the session")), qPrintable(shot.out));
    }

    void whatAMeshRefersToIsNotReplaced_data() {
        QTest::addColumn<QStringList>("command");
        const auto row = [](const char* name, const QStringList& command) { QTest::newRow(name) << command; };
        row("report", {"shoot", "--random", "1", "--report", "@my paint.mtl", "@mesh.obj"});
        row("hits", {"shoot", "--random", "1", "--hits-out", "@my paint.mtl", "@mesh.obj"});
        row("picture", {"shoot", "--random", "1", "--picture", "@wood.png", "@mesh.obj"});
        row("drawn", {"picture", "@wood.png", "@mesh.obj"});
        row("convert", {"convert", "--format", "obj", "@mesh.obj", "@my paint.mtl"});
        row("buffer", {"convert", "--format", "obj", "@mesh.gltf", "@mesh.bin"});
        row("session", {"export", "--report", "@my paint.mtl", "--out", "@x.obj", "@s.hitscope"});
        row("info", {"info", "--report", "@my paint.mtl", "@mesh.gltf", "@mesh.obj"});
    }
    void whatAMeshRefersToIsNotReplaced() {
        QFETCH(QStringList, command);
        QVERIFY(runCli({"convert", at("mesh.obj"), at("mesh.gltf")}).status == 0);
        const QDir::Filters all = QDir::AllEntries | QDir::NoDotAndDotDot;
        const QStringList before = QDir(m_folder->path()).entryList(all);
        QVERIFY2(before.contains(QStringLiteral("mesh.bin")), qPrintable(before.join(u' ')));
        std::map<QString, QByteArray> contents;
        for (const QString& name : before) {
            contents[name] = contentOf(m_folder->filePath(name));
        }
        const CliRun run = runCli(command.replaceInStrings(QStringLiteral("@"), m_folder->path() + u'/'));
        QVERIFY2(run.status == 3, qPrintable(QString::number(run.status) + run.out + run.err));
        QVERIFY2(run.err.contains(QStringLiteral("which is read as well")), qPrintable(run.err));
        QCOMPARE(QDir(m_folder->path()).entryList(all), before);
        for (const QString& name : before) {
            QVERIFY2(contents[name] == contentOf(m_folder->filePath(name)), qPrintable(name));
        }
    }

    void inputsAreNotReplaced_data() {
        QTest::addColumn<QStringList>("command");
        QTest::addColumn<int>("status");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, const QString& command, int status, const QString& says) {
            QTest::newRow(name) << command.split(u' ') << status << says;
        };
        const QString read = QStringLiteral("which is read as well");
        row("the mesh", "shoot --random 1 --out mesh.obj mesh.obj", 2, read);
        row("by another way", "shoot --random 1 --out ./mesh.obj mesh.obj", 2, read);
        row("as a session", "shoot --random 1 --session mesh.obj mesh.obj", 2, read);
        row("as hits", "shoot --random 1 --hits-out mesh.obj mesh.obj", 2, read);
        row("a session's mesh", "export --out mesh.obj s.hitscope", 3,
            QStringLiteral("is read from that file"));
        row("a session", "export --format obj --out s.hitscope s.hitscope", 2, read);
        row("convert", "convert mesh.obj mesh.obj", 2, read);
        row("two in one", "shoot --session x.obj --out x.obj mesh.obj", 2, QStringLiteral("both name"));
        row("no session", "shoot --session x.json mesh.obj", 2, QStringLiteral(".hitscope"));
        row("no report", "changes --report other.obj s.hitscope", 2, QStringLiteral("neither a mesh"));
        row("two streams", "section --plane x=0.3 --csv - --svg - mesh.obj", 2, QStringLiteral("both write"));
        row("JSON and more", "shoot --json --hits-out - mesh.obj", 2, QStringLiteral("both write"));
        row("swapped", "picture mesh.obj a.png", 2, QStringLiteral("comes first"));
        row("a film", "sequence --turntable 2 a.avi mesh.obj", 2, QStringLiteral(".mp4"));
        row("no folder", "shoot --random 1 --out none/x.obj mesh.obj", 3,
            QStringLiteral("a folder that is not there"));
    }
    void inputsAreNotReplaced() {
        QFETCH(const QStringList, command);
        QFETCH(const int, status);
        QFETCH(const QString, says);
        const QByteArray mesh = contentOf(at("mesh.obj"));
        const QByteArray session = contentOf(at("s.hitscope"));
        const QStringList before = QDir(m_folder->path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot);
        QStringList arguments = command;
        for (QString& word : arguments) {
            word = word.contains(u'.') ? m_folder->path() + u'/' + word : word;
        }
        arguments.replaceInStrings(m_folder->path() + QStringLiteral("/x=0.3"), QStringLiteral("x=0.3"));
        const CliRun run = runCli(arguments);
        QVERIFY2(run.status == status, qPrintable(run.out + run.err));
        QVERIFY2(run.err.contains(says), qPrintable(run.err));
        QCOMPARE(contentOf(at("mesh.obj")), mesh);
        QCOMPARE(contentOf(at("s.hitscope")), session);
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot), before);
    }

    /// Nothing is written, and no work done, where one of the outputs has no place.
    void foldersAreLookedForFirst() {
        for (const QString& out : {at("gone/x.obj"), m_folder->path()}) {
            const CliRun run = runCli(
                {"shoot", "--random", "3", "--session", at("kept.hitscope"), "--out", out, at("mesh.obj")});
            QCOMPARE(run.status, 3);
            QVERIFY2(run.err.contains(QStringLiteral("--out names")), qPrintable(run.err));
            QVERIFY(run.out.isEmpty());
            QVERIFY(!QFileInfo::exists(at("kept.hitscope")));
        }
    }

    void devicesAreNotReplaced() {
        for (const char* device : {"/dev/null", "/dev/stdout"}) {
            const CliRun run = runCli({"export", "--format", "obj", "--out", device, at("s.hitscope")});
            QCOMPARE(run.status, 3);
            QVERIFY2(run.err.contains(QStringLiteral("a device or a pipe")), qPrintable(run.err));
        }
    }

    void aSessionMayBeGoneOnWith() {
        const QString session = at("s.hitscope");
        const CliRun more = runCli({"shoot", "--random", "1", "--session", session, session});
        QVERIFY2(more.status == 0, qPrintable(more.err));
        const CliRun replayed = runCli({"replay", session});
        QVERIFY2(replayed.out.startsWith(QStringLiteral("3 of 3 hits on 1 target\n")),
                 qPrintable(replayed.out));
    }

    void aSessionGoesToTheStandardOutput() {
        const CliRun shot = runCli({"shoot", "--random", "1", "--session", "-", at("mesh.obj")});
        QVERIFY2(shot.status == 0, qPrintable(shot.err));
        QVERIFY2(shot.out.startsWith(u'{') && shot.out.trimmed().endsWith(u'}'), qPrintable(shot.out));
    }

    /// What it writes has names that nobody gives.
    void demosReplaceNothingThatTheyRead() {
        QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("demo")));
        const QByteArray mesh = contentOf(at("mesh.obj"));
        const QDir folder(at("demo"));
        QString deformed = writeBytes(folder.filePath(QStringLiteral("deformed.obj")), mesh);
        const CliRun onItself = runCli({"demo", "--shots", "1", "--out", folder.path(), deformed});
        QCOMPARE(onItself.status, 2);
        QVERIFY2(
            onItself.err.contains(QStringLiteral("--out writes %1, which is read as well").arg(deformed)),
            qPrintable(onItself.err));
        QCOMPARE(contentOf(deformed), mesh);
        QVERIFY(QFile::remove(deformed));
        const QString other = writeBytes(folder.filePath(QStringLiteral("other.obj")),
                                         QByteArray(mesh).replace("my paint.mtl", "after.mtl"));
        writeBytes(folder.filePath(QStringLiteral("after.mtl")), "newmtl red\nmap_Kd after.png\n");
        const QString picture = folder.filePath(QStringLiteral("after.png"));
        QVERIFY(QFile::copy(at("wood.png"), picture));
        const CliRun onTexture = runCli({"demo", "--shots", "1", "--out", folder.path(), other});
        QCOMPARE(onTexture.status, 3);
        QVERIFY2(onTexture.err.contains(QStringLiteral("which is read as well")), qPrintable(onTexture.err));
        QCOMPARE(contentOf(picture), contentOf(at("wood.png")));
        QCOMPARE(folder.entryList(QDir::Files),
                 (QStringList{QStringLiteral("after.mtl"), QStringLiteral("after.png"),
                              QStringLiteral("other.obj")}));
    }

    void sequencesReplaceNothingThatTheyRead() {
        const QByteArray mesh = contentOf(at("mesh.obj"));
        for (const char* const base : {"turntable", "replay"}) {
            const QString texture = QLatin1String(base) + QStringLiteral("-0002.png");
            writeBytes(at("frames.mtl"), "newmtl red\nmap_Kd " + texture.toLatin1() + "\n");
            writeBytes(at("framed.obj"), QByteArray(mesh).replace("my paint.mtl", "frames.mtl"));
            QVERIFY(QFile::copy(at("wood.png"), m_folder->filePath(texture)));
            const CliRun shot =
                runCli({"shoot", "--random", "2", "--session", at("framed.hitscope"), at("framed.obj")});
            QVERIFY2(shot.status == 0, qPrintable(shot.err));
            const bool turns = QLatin1String(base) == QLatin1String("turntable");
            QStringList command{"sequence", "--size", "64x36"};
            command << (turns ? QStringList{"--turntable", "2"} : QStringList{"--replay"});
            const CliRun run = runCli(command + QStringList{m_folder->path(), at("framed.hitscope")});
            QCOMPARE(run.status, 3);
            QVERIFY2(run.err.contains(QStringLiteral("FOLDER writes a file of \"framed\", which is read")),
                     qPrintable(run.err));
            QCOMPARE(contentOf(m_folder->filePath(texture)), contentOf(at("wood.png")));
            QVERIFY(
                !QFileInfo::exists(m_folder->filePath(QLatin1String(base) + QStringLiteral("-0001.png"))));
            const CliRun elsewhere = runCli(command + QStringList{at("frames"), at("framed.hitscope")});
            QVERIFY2(elsewhere.status == 0, qPrintable(elsewhere.err));
        }
    }

    void aMeshOnTheStandardOutputHasAReport_data() {
        QTest::addColumn<QStringList>("command");
        QTest::newRow("convert") << QStringList{"convert", "--format", "obj", "@mesh.obj", "-"};
        QTest::newRow("export") << QStringList{"export", "--format", "obj", "--out", "-", "@s.hitscope"};
    }
    void aMeshOnTheStandardOutputHasAReport() {
        QFETCH(QStringList, command);
        command.replaceInStrings(QStringLiteral("@"), m_folder->path() + u'/');
        const CliRun plain = runCli(command);
        const CliRun run = runCli(command + QStringList{"--report", at("r.json")});
        QVERIFY2(run.status == 0, qPrintable(run.err));
        QVERIFY(!plain.out.isEmpty());
        QCOMPARE(run.out, plain.out);
        const QJsonObject report = QJsonDocument::fromJson(contentOf(at("r.json"))).object();
        QCOMPARE(report["report"].toString(), command[0]);
        QCOMPARE(report["file"].toString(), QStringLiteral("-"));
        QCOMPARE(report["bytes"].toInteger(), plain.out.toUtf8().size());
    }

    /// A reader goes by the suffix; the standard output has none, and is checked all the same.
    void checksNeedTheSuffixOfTheFormat() {
        const CliRun wrong = runCli({"convert", "--format", "stl", "--check", at("mesh.obj"), at("z.obj")});
        QCOMPARE(wrong.status, 2);
        QVERIFY2(wrong.err.contains(QStringLiteral("--check reads the file back by its suffix")),
                 qPrintable(wrong.err));
        QVERIFY(!QFileInfo::exists(at("z.obj")));
        const CliRun text =
            runCli({"convert", "--format", "ply-ascii", "--check", at("mesh.obj"), at("z.PLY")});
        QVERIFY2(text.status == 0, qPrintable(text.err));
        const CliRun stream = runCli(
            {"convert", "--format", "ply-ascii", "--check", "--report", at("r.json"), at("mesh.obj"), "-"});
        QVERIFY2(stream.status == 0, qPrintable(stream.err));
        QVERIFY(stream.out.startsWith(QStringLiteral("ply\n")));
        QVERIFY(QJsonDocument::fromJson(contentOf(at("r.json"))).object()["was_read_back"].toBool());
    }

    void aStreamHasNoFilesBesideIt() {
        const CliRun run = runCli({"convert", "--format", "obj", at("mesh.obj"), "-"});
        QVERIFY2(run.status == 0, qPrintable(run.err));
        QVERIFY2(!run.err.contains(QStringLiteral("written beside")), qPrintable(run.err));
        QVERIFY2(run.err.contains(QStringLiteral("no room for: my paint.mtl, wood.png")),
                 qPrintable(run.err));
        const CliRun filed = runCli({"convert", at("mesh.obj"), at("copies/x.obj")});
        QCOMPARE(filed.status, 3);  // no such folder
        QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("copies")));
        const CliRun again = runCli({"convert", at("mesh.obj"), at("copies/x.obj")});
        QVERIFY2(again.err.contains(QStringLiteral("Also written beside it")), qPrintable(again.err));
    }

    void onlyOneReadsTheStandardInput() {
        for (const QStringList& given :
             {QStringList{"verify", "--hits", "-", "-"}, QStringList{"compare", "-", "-"}}) {
            const CliRun run = runCli(given);
            QCOMPARE(run.status, 2);
            QVERIFY2(run.err.contains(QStringLiteral("both read the standard input")), qPrintable(run.err));
        }
    }

    void picturesThatAreLeftAreNoted() {
        const QStringList sequence{"sequence", "--size", "64x36", "--turntable"};
        QVERIFY(runCli(sequence + QStringList{"3", at("frames"), at("mesh.obj")}).status == 0);
        const CliRun fewer = runCli(sequence + QStringList{"2", at("frames"), at("mesh.obj")});
        QVERIFY2(fewer.err.contains(QStringLiteral("1 more picture of an earlier")), qPrintable(fewer.err));
    }

private:
    [[nodiscard]] QString at(const char* name) const { return m_folder->filePath(QLatin1String(name)); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

HITSCOPE_TEST(OutputsTest, QCoreApplication)

}  // namespace hitscope::outputs_test

#include "outputs_test.moc"
