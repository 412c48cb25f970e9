// SPDX-License-Identifier: GPL-3.0-or-later
// hitscope-cli as a person runs it: arguments in, text, files and exit status out.
#include <QImage>
#include <QTemporaryDir>
#include <QTest>
#include <array>

#include "cli/run_cli.h"
#include "gl/context.h"
#include "io/import.h"
#include "support/test_program.h"

namespace hitscope::cli_test {

using namespace test;

namespace {

QString writeFile(const QTemporaryDir& folder, const QString& name, const QByteArray& bytes) {
    QFile file(folder.filePath(name));
    if (file.open(QIODevice::WriteOnly)) {
        file.write(bytes);
    }
    return file.fileName();
}

/// 10 * major + minor of this renderer; 0: there is none.
int openGlVersion() {
    const auto context = gl::OffscreenContext::create();
    return context ? 10 * gl::rendererInfo().major + gl::rendererInfo().minor : 0;
}

/// Empty: the pipeline that is used unless another is asked for is exact here; else what it is told of it.
QString whyNotExact() {
    const CliRun run = runCli({QStringLiteral("info"), QStringLiteral("--renderer")});
    for (const QString& line : run.out.split(u'\n')) {
        if (line.contains(QStringLiteral("Transform feedback ")) &&
            line.contains(QStringLiteral("not bit-exact"))) {
            return line.simplified();
        }
    }
    return {};
}

/// What `info` prints in the row of that name; empty: there is no such row.
QString valueOf(const CliRun& run, const QString& name) {
    const QRegularExpression row(QStringLiteral("^ *%1  +(.*)$").arg(name),
                                 QRegularExpression::MultilineOption);
    return row.match(run.out).captured(1).trimmed();
}

/// The unit cube as OBJ, each side with four vertices of its own.
QByteArray splitCube() {
    QByteArray text;
    for (int side = 0; side < 6; ++side) {
        const int axis = side / 2;
        const bool isFar = side % 2 == 1;
        for (int corner = 0; corner < 4; ++corner) {
            std::array<int, 3> place{};
            const auto along = [&](int shift) -> int& {
                return place[static_cast<std::size_t>((axis + shift) % 3)];
            };
            along(0) = isFar ? 1 : 0;
            along(isFar ? 1 : 2) = corner == 1 || corner == 2 ? 1 : 0;
            along(isFar ? 2 : 1) = corner >= 2 ? 1 : 0;
            text += "v " + QByteArray::number(place[0]) + ' ' + QByteArray::number(place[1]) + ' ' +
                    QByteArray::number(place[2]) + '\n';
        }
        text += "f -4 -3 -2 -1\n";
    }
    return text;
}

bool isPicture(const QString& path) {
    const QImage image(path);
    if (image.width() != 1280 || image.height() != 720) {
        return false;
    }
    const QRgb corner = image.pixel(0, 0);
    for (int x = 0; x < image.width(); ++x) {
        if (image.pixel(x, image.height() / 2) != corner) {
            return true;
        }
    }
    return false;
}

}  // namespace

class CliTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void demoWritesPicturesAndMesh() {
        const QTemporaryDir folder;
        const QString out = folder.filePath(QStringLiteral("new/folder"));
        const CliRun run = runCli({QStringLiteral("demo"), QStringLiteral("--out"), out});
        QVERIFY2(run.status == 0, qPrintable(run.err));
        const QString notExact = whyNotExact();
        QCOMPARE(run.err.isEmpty(), notExact.isEmpty());  // else it says what was used in its place
        for (const char* name : {"before.png", "after.png", "wireframe.png"}) {
            QVERIFY2(isPicture(out + QLatin1Char('/') + QLatin1String(name)), name);
        }
        QVERIFY(QImage(out + QStringLiteral("/before.png")) != QImage(out + QStringLiteral("/after.png")));
        QVERIFY(QImage(out + QStringLiteral("/after.png")) != QImage(out + QStringLiteral("/wireframe.png")));
        QVERIFY(importMesh(out + QStringLiteral("/deformed.obj")));
        QVERIFY(run.out.contains(QStringLiteral("50 shots")));
        if (!notExact.isEmpty()) {
            QSKIP(qPrintable(notExact));
        }
        const bool computes = openGlVersion() >= 43;
        for (const char* name : {"Uniform array", "Uniform array, culled", "Transform feedback", "Compute"}) {
            const bool isHere = computes || std::string_view(name) != "Compute";
            const QString said = isHere ? QStringLiteral(": as the reference in every bit\n")
                                        : QStringLiteral(": not here. Compute shaders need OpenGL 4.3");
            QVERIFY2(run.out.contains(QLatin1String(name) + said), name);
        }
        QVERIFY(run.out.contains(QStringLiteral("Reference: as every hit at every vertex, in every bit\n")));
        QVERIFY(run.out.contains(QStringLiteral("bit-exact")));
    }

    // Whoever's result is exported, it is the same mesh; the normals are those asked for.
    void demoShowsThePipelineAskedFor() {
        if (const QString notExact = whyNotExact(); !notExact.isEmpty()) {
            QSKIP(qPrintable(notExact));
        }
        const QTemporaryDir folder;
        const auto exported = [&folder](const QString& pipeline, const QString& normals) {
            const QString out = folder.filePath(pipeline + normals);
            const CliRun run =
                runCli({QStringLiteral("demo"), QStringLiteral("--out"), out, QStringLiteral("--shots"),
                        QStringLiteral("20"), QStringLiteral("--pipeline"), pipeline,
                        QStringLiteral("--normals"), normals});
            QFile file(out + QStringLiteral("/deformed.obj"));
            return run.status == 0 && file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        };
        const QString feedback = QStringLiteral("transform-feedback");
        const QByteArray mesh = exported(feedback, QStringLiteral("true"));
        QVERIFY(!mesh.isEmpty());
        QCOMPARE(exported(QStringLiteral("reference"), QStringLiteral("true")), mesh);
        const QByteArray paper = exported(feedback, QStringLiteral("paper"));
        QVERIFY(!paper.isEmpty() && paper != mesh);
    }

    void demoTakesAMesh() {
        const QTemporaryDir folder;
        const QString mesh =
            writeFile(folder, QStringLiteral("tent.obj"),
                      "v -2 0 0\nv 2 0 0\nv 0 3 0\nv 0 1 3\nf 1 2 3\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
        const CliRun run = runCli({QStringLiteral("demo"), QStringLiteral("--out"), folder.path(), mesh});
        QVERIFY2(run.status == 0, qPrintable(run.err));
        QVERIFY(run.out.contains(QStringLiteral("tent")));
    }

    void infoPrintsWhatIsThere() {
        const QTemporaryDir folder;
        const QString mesh =
            writeFile(folder, QStringLiteral("tetra.obj"),
                      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 9 9 9\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
        const CliRun run = runCli({QStringLiteral("info"), mesh});
        QVERIFY2(run.status == 0, qPrintable(run.err));
        const auto value = [&run](const QString& name) { return valueOf(run, name); };
        QCOMPARE(value(QStringLiteral("vertices")), QStringLiteral("5"));
        QCOMPARE(value(QStringLiteral("used by no face")), QStringLiteral("1"));
        QCOMPARE(value(QStringLiteral("edges")), QStringLiteral("6"));
        QCOMPARE(value(QStringLiteral("faces")), QStringLiteral("4"));
        QCOMPARE(value(QStringLiteral("watertight")), QStringLiteral("yes"));
        QCOMPARE(value(QStringLiteral("volume")), QStringLiteral("0.166667"));
    }

    void infoHasOneWordForNoVolume() {
        const QTemporaryDir folder;
        const QByteArray vertices = "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 0 0\n";
        const QString open = writeFile(folder, QStringLiteral("open.obj"), vertices + "f 1 2 3\nf 2 1 4\n");
        const QString fan =
            writeFile(folder, QStringLiteral("fan.obj"), vertices + "f 1 2 3\nf 1 2 4\nf 1 2 5\n");
        for (const QString& mesh : {open, fan}) {
            const CliRun run = runCli({QStringLiteral("info"), mesh});
            QCOMPARE(valueOf(run, QStringLiteral("volume")), QStringLiteral("open"));
        }
    }

    /// A cube of six sheets that share no vertex encloses a volume all the same.
    void infoWeldsSplitVertices() {
        const QTemporaryDir folder;
        const QString mesh = writeFile(folder, QStringLiteral("split.obj"), splitCube());
        const CliRun run = runCli({QStringLiteral("info"), mesh});
        QVERIFY2(run.status == 0, qPrintable(run.err));
        QCOMPARE(valueOf(run, QStringLiteral("vertices")), QStringLiteral("24"));
        QCOMPARE(valueOf(run, QStringLiteral("at another's place")), QStringLiteral("16"));
        QCOMPARE(valueOf(run, QStringLiteral("edges")), QStringLiteral("12"));
        QCOMPARE(valueOf(run, QStringLiteral("on a boundary")), QString());
        QCOMPARE(valueOf(run, QStringLiteral("connected components")), QStringLiteral("1"));
        QCOMPARE(valueOf(run, QStringLiteral("Euler characteristic")), QStringLiteral("2"));
        QCOMPARE(valueOf(run, QStringLiteral("genus")), QStringLiteral("0"));
        QCOMPARE(valueOf(run, QStringLiteral("watertight")), QStringLiteral("yes"));
        QCOMPARE(valueOf(run, QStringLiteral("volume")), QStringLiteral("1"));
    }

    void badInputFailsWithOneMessage_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("bytes");
        QTest::addRow("empty") << QStringLiteral("empty.obj") << QByteArray();
        QTest::addRow("no faces") << QStringLiteral("points.obj") << QByteArray("v 0 0 0\n");
        QTest::addRow("bad index") << QStringLiteral("index.obj") << QByteArray("v 0 0 0\nf 1 2 3\n");
        QTest::addRow("truncated") << QStringLiteral("cut.ply")
                                   << QByteArray("ply\nformat ascii 1.0\nelement vertex 3\n");
        QTest::addRow("not a mesh") << QStringLiteral("picture.glb") << QByteArray("\x89PNG\r\n\x1a\n");
        QTest::addRow("unknown suffix") << QStringLiteral("notes.txt") << QByteArray("hello\n");
    }
    void badInputFailsWithOneMessage() {
        QFETCH(QString, name);
        QFETCH(QByteArray, bytes);
        const QTemporaryDir folder;
        const QString mesh = writeFile(folder, name, bytes);
        for (const QStringList& arguments :
             {QStringList{QStringLiteral("info"), mesh},
              QStringList{QStringLiteral("demo"), QStringLiteral("--out"), folder.path(), mesh}}) {
            const CliRun run = runCli(arguments);
            QCOMPARE(run.status, 3);
            QCOMPARE(run.err.count(QLatin1Char('\n')), 1);
            QVERIFY2(run.err.contains(name), qPrintable(run.err));
            QVERIFY(!QFile::exists(folder.filePath(QStringLiteral("deformed.obj"))));
        }
    }

    void missingFileIsNamed() {
        const CliRun run = runCli({QStringLiteral("info"), QStringLiteral("/nowhere/mesh.obj")});
        QCOMPARE(run.status, 3);
        QVERIFY2(run.err.contains(QStringLiteral("/nowhere/mesh.obj")), qPrintable(run.err));
    }

    void helpNamesTheCommand() {
        for (const char* const command :
             {"demo",        "shoot",         "picture",       "sequence",  "info",
              "replay",      "verify",        "export",        "convert",   "compare",
              "changes",     "explain",       "dents",         "section",   "sweep",
              "collect",     "help",          "bench frame",   "bench hit", "bench paper",
              "bench modes", "bench physics", "bench session", "bench io",  "bench check"}) {
            const QString name = QString::fromLatin1(command);
            const CliRun run = runCli(name.split(u' ') << QStringLiteral("--help"));
            QCOMPARE(run.status, 0);
            QVERIFY2(run.out.startsWith(QStringLiteral("Usage: hitscope-cli %1 [options]").arg(name)),
                     qPrintable(run.out.left(80)));
        }
    }

    void complainsInWholeSentences() {
        for (const char* const command :
             {"demo", "shoot", "picture", "sequence", "info", "export", "sweep", "help", "bench frame"}) {
            const CliRun run =
                runCli(QString::fromLatin1(command).split(u' ') << QStringLiteral("--nonsense"));
            QCOMPARE(run.status, 2);
            QVERIFY2(run.err.contains(QStringLiteral("nonsense'.\n")), qPrintable(run.err));
        }
    }

    void saysThatItsOutputIsLost() {
        const QTemporaryDir folder;
        const QString mesh =
            writeFile(folder, QStringLiteral("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        const QString other =
            writeFile(folder, QStringLiteral("b.obj"), "v 0 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n");
        QCOMPARE(runCli({QStringLiteral("compare"), mesh, other}).status, 1);
        for (const QString& line : {QStringLiteral("info ") + mesh, QStringLiteral("--help"),
                                    QStringLiteral("compare %1 %2").arg(mesh, other),
                                    QStringLiteral("--version"), QStringLiteral("bench frame --help")}) {
            QProcess shell;
            shell.start(
                QStringLiteral("/bin/sh"),
                {QStringLiteral("-c"), QStringLiteral("exec \"$HITSCOPE_CLI\" %1 >/dev/full").arg(line)});
            QVERIFY(shell.waitForFinished(60'000));
            const QByteArray said = shell.readAllStandardError();
            QCOMPARE(shell.exitCode(), 3);
            QVERIFY2(said.contains("No space left on device"), said.constData());
        }
    }

    void wrongUsageIsToldApart_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addRow("no command") << QStringList{};
        QTest::addRow("unknown command") << QStringList{QStringLiteral("fly")};
        QTest::addRow("pipeline") << QStringList{QStringLiteral("demo"), QStringLiteral("--pipeline"),
                                                 QStringLiteral("magic")};
        QTest::addRow("normals") << QStringList{QStringLiteral("demo"), QStringLiteral("--normals"),
                                                QStringLiteral("soft")};
        QTest::addRow("unknown option") << QStringList{QStringLiteral("demo"), QStringLiteral("--fast")};
        QTest::addRow("shots") << QStringList{QStringLiteral("demo"), QStringLiteral("--shots"),
                                              QStringLiteral("x")};
        QTest::addRow("info without mesh") << QStringList{QStringLiteral("info")};
    }
    void wrongUsageIsToldApart() {
        QFETCH(QStringList, arguments);
        const CliRun run = runCli(arguments);
        QCOMPARE(run.status, 2);
        QVERIFY(run.err.contains(QStringLiteral("--help")));
    }

    void folderThatCannotBeMade() {
        const QTemporaryDir folder;
        const QString blocked = writeFile(folder, QStringLiteral("file"), "x");
        const CliRun run =
            runCli({QStringLiteral("demo"), QStringLiteral("--out"), blocked + QStringLiteral("/in")});
        QCOMPARE(run.status, 3);
        QVERIFY(run.err.contains(blocked));
    }
};

HITSCOPE_TEST(CliTest, QCoreApplication)

}  // namespace hitscope::cli_test

#include "cli_test.moc"
