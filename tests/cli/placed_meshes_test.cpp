// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes far from the origin, huge and tiny ones: what hitscope-cli says of them is in their files'
// coordinates, or it says how the scene's come from these. And what needs no OpenGL does without.
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "cli/run_cli.h"
#include "cli/scene_files.h"
#include "support/test_program.h"

namespace hitscope::placed_meshes_test {

using namespace test;

namespace {

/// A sheet of 5 x 5 vertices, of that size about a place; the last vertex is `lifted`.
QByteArray sheetObj(double place, double size, double lifted = 0.0) {
    QByteArray text;
    const auto number = [](double value) { return ' ' + QByteArray::number(value, 'g', 17); };
    for (int i = 0; i < 25; ++i) {
        const int column = i % 5;
        const int row = i / 5;
        text += "v" + number(place + size * column / 4.0) + number(size * row / 4.0) +
                number(i == 24 ? lifted : 0.0) + '\n';
    }
    for (int i = 0; i < 16; ++i) {
        const int first = i / 4 * 5 + i % 4 + 1;
        text += "f " + QByteArray::number(first) + ' ' + QByteArray::number(first + 5) + ' ' +
                QByteArray::number(first + 6) + ' ' + QByteArray::number(first + 1) + '\n';
    }
    return text;
}

QJsonObject jsonOf(const CliRun& run) {
    return QJsonDocument::fromJson(run.out.toUtf8()).object();
}

}  // namespace

class PlacedMeshesTest : public QObject {
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    [[nodiscard]] QString in(const QString& name) const { return m_folder.filePath(name); }

private Q_SLOTS:
    void comparisonsAreInFileCoordinates_data() {
        QTest::addColumn<QByteArray>("a");
        QTest::addColumn<QByteArray>("b");
        QTest::addColumn<double>("largest");
        // A tenth of a metre is no float there, so that the meshes are moved to the origin.
        QTest::newRow("the second one far away") << sheetObj(0.1, 1.0) << sheetObj(1000.1, 1.0) << 1000.0;
        QTest::newRow("both far away") << sheetObj(1000.1, 1.0) << sheetObj(2000.1, 1.0) << 1000.0;
        QTest::newRow("three metres apart") << sheetObj(499950.1, 100.0) << sheetObj(499953.1, 100.0) << 3.0;
        QTest::newRow("of two sizes")
            << sheetObj(0.0, 1.0e10) << sheetObj(0.0, 2.0e10) << std::sqrt(2.0) * 1e10;
        QTest::newRow("huge, one vertex moved")
            << sheetObj(0.0, 1.0e10) << sheetObj(0.0, 1.0e10, 1.0e8) << 1.0e8;
        QTest::newRow("tiny, one vertex moved")
            << sheetObj(0.0, 1.0e-8) << sheetObj(0.0, 1.0e-8, 1.0e-10) << 1.0e-10;
        QTest::newRow("equal") << sheetObj(499950.1, 100.0) << sheetObj(499950.1, 100.0) << 0.0;
    }
    void comparisonsAreInFileCoordinates() {
        QFETCH(const QByteArray, a);
        QFETCH(const QByteArray, b);
        QFETCH(const double, largest);
        const CliRun run =
            runCli({"compare", "--json", writeBytes(in("a.obj"), a), writeBytes(in("b.obj"), b)});
        QCOMPARE(run.status, largest > 0.0 ? 1 : 0);
        const QJsonObject target = jsonOf(run)["targets"].toArray()[0].toObject();
        QVERIFY2(std::abs(target["largest_m"].toDouble() - largest) <= 1.0e-6 * largest, qPrintable(run.out));
    }

    void tolerancesTellBitsFromDistances() {
        const QString a = writeBytes(in("zero.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        const QString b = writeBytes(in("minus.obj"), "v -0.0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        const CliRun bits = runCli({"compare", a, b});
        QCOMPARE(bits.status, 1);
        QVERIFY2(bits.err.contains(QStringLiteral("in some bits")), qPrintable(bits.err));
        QCOMPARE(runCli({"compare", "--tolerance", "0", a, b}).status, 0);
        const QString turned = writeBytes(in("turned.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 2 3 1\n");
        const CliRun other = runCli({"compare", a, turned});
        QVERIFY2(other.err.contains(QStringLiteral("face 1 ")), qPrintable(other.err));
    }

    void infoMeasuresTheFile_data() {
        QTest::addColumn<double>("place");
        QTest::addColumn<double>("size");
        QTest::newRow("far away") << 499950.1 << 100.0;
        QTest::newRow("huge") << -1.0e19 << 1.0e20;
        QTest::newRow("tiny") << 0.0 << 1.0e-8;
    }
    void infoMeasuresTheFile() {
        QFETCH(const double, place);
        QFETCH(const double, size);
        const CliRun run = runCli({"info", "--json", writeBytes(in("a.obj"), sheetObj(place, size))});
        QCOMPARE(run.status, 0);
        const QJsonObject file = jsonOf(run)["files"].toArray()[0].toObject();
        const QJsonObject measured = file["targets"].toArray()[0].toObject()["original"].toObject();
        const auto isAbout = [&measured](const char* key, double meant) {
            return std::abs(measured[QLatin1String(key)].toDouble() - meant) <= 1.0e-5 * std::abs(meant);
        };
        QVERIFY2(isAbout("box_min_x", place), qPrintable(run.out));
        QVERIFY2(isAbout("box_max_x", place + size), qPrintable(run.out));
        QVERIFY2(isAbout("box_size_y", size), qPrintable(run.out));
        QVERIFY2(isAbout("edge_length_mean", size / 4.0), qPrintable(run.out));
        QVERIFY2(isAbout("surface_area", size * size), qPrintable(run.out));
        QVERIFY2(
            file["notes"].toArray()[0].toString().contains(QStringLiteral("In the scene it is moved by (")),
            qPrintable(run.out));
    }

    /// With the numbers that the note gives, a place of the file can be shot at.
    void sessionsSayHowTheyWerePlaced() {
        const QString mesh = writeBytes(in("far.obj"), sheetObj(499950.1, 100.0));
        const CliRun shot = runCli(
            {"shoot", "--at", "0,3,50", "--direction", "0,0,-1", "--session", in("far.hitscope"), mesh});
        QVERIFY2(shot.out.contains(QStringLiteral("1 shot, 1 hit")), qPrintable(shot.out + shot.err));
        const QString placed = QStringLiteral("In the scene it is moved by (-500000, -50, 0).");
        QVERIFY2(shot.err.contains(placed), qPrintable(shot.err));
        const CliRun changes = runCli({"changes", in("far.hitscope")});
        QVERIFY2(changes.err.contains(QStringLiteral("far: ") + placed), qPrintable(changes.err));
        QVERIFY(runCli({"changes", in("far.hitscope"), "--quiet"}).err.isEmpty());
    }

    /// The same numbers as in an export; where a report is in the scene's, it says how they were placed.
    void changesAreInFileCoordinates() {
        const QString mesh = writeBytes(in("large.obj"), sheetObj(-5.0e19, 1.0e20));
        const CliRun shot = runCli({"shoot", "--at", "0,0,0", "--session", in("large.hitscope"), mesh});
        QVERIFY2(shot.out.contains(QStringLiteral("1 shot, 1 hit")), qPrintable(shot.out + shot.err));
        const QStringList changes = runCli({"changes", in("large.hitscope")}).out.split(u'\n');
        const QStringList exported =
            runCli({"export", "--format", "csv", "--out", "-", in("large.hitscope")}).out.split(u'\n');
        QVERIFY(changes.size() > 2);
        QCOMPARE(changes.size(), exported.size());
        const QStringList a = changes[1].split(u',');
        const QStringList b = exported[1].split(u',');
        QVERIFY2(std::abs(a[3].toDouble()) > 1.0e18, qPrintable(changes[1]));
        QCOMPARE(a.mid(1, 10), b.mid(0, 10));  // vertex, original, current, displacement
        QVERIFY(std::abs(a[11].toDouble() / b[10].toDouble() - 1.0) < 1.0e-6);
        const auto scaleOf = [](const QJsonObject& object) {
            return object["placement"].toObject()["scale"].toDouble();
        };
        const QJsonObject explained =
            jsonOf(runCli({"explain", "--json", "--vertex", a[1], in("large.hitscope")}));
        QVERIFY(scaleOf(explained) > 0.0 && scaleOf(explained) < 1.0e-15);
        const QJsonObject cut = jsonOf(runCli({"section", "--json", "--plane", "y=0.3", mesh}));
        QCOMPARE(scaleOf(cut["targets"].toArray()[0].toObject()), scaleOf(explained));
        const CliRun text = runCli({"section", "--quiet", "--plane", "y=0.3", mesh});
        QVERIFY2(text.out.contains(QStringLiteral("In the scene it is moved by")), qPrintable(text.out));
    }

    /// Of a mesh that is not moved, though floats do not hold its coordinates.
    void changesHaveAllDigitsOfTheFile() {
        const QString mesh = writeBytes(in("fine.obj"), sheetObj(0.523456789, 1.0));
        const CliRun shot = runCli(
            {"shoot", "--at", "0.7,0.4,0", "--max-distance", "2", "--session", in("fine.hitscope"), mesh});
        QVERIFY2(shot.out.contains(QStringLiteral("1 shot, 1 hit")), qPrintable(shot.out + shot.err));
        const CliRun changes = runCli({"changes", in("fine.hitscope")});
        QVERIFY2(changes.err.isEmpty(), qPrintable(changes.err));
        QVERIFY2(changes.out.contains(QStringLiteral(",0.523456789,0.25,0,0.523456789,")),
                 qPrintable(changes.out));
        const QStringList rows = changes.out.split(u'\n');
        const QStringList exported =
            runCli({"export", "--format", "csv", "--out", "-", in("fine.hitscope")}).out.split(u'\n');
        QCOMPARE(rows.size(), exported.size());
        for (qsizetype i = 1; i + 1 < rows.size(); ++i) {
            QCOMPARE(rows[i].split(u',').mid(1, 10), exported[i].split(u',').mid(0, 10));
        }
        const QJsonObject report = jsonOf(runCli({"changes", "--json", in("fine.hitscope")}));
        const QJsonObject first =
            report["targets"].toArray()[0].toObject()["vertices"].toArray()[0].toObject();
        QCOMPARE(first["original_m"].toArray()[0].toDouble(), 0.523456789);
    }

    void shotsAtAPlaceComeFromOutside() {
        const QString mesh = writeBytes(in("flat.obj"), sheetObj(0.0, 1.0));
        for (const char* place : {"0.3,0.3,0", "0.3,0.3,-2", "0.3,0.3,-500"}) {
            const CliRun run = runCli({"shoot", "--at", place, "--direction", "0,0,-1", mesh});
            QVERIFY2(run.out.contains(QStringLiteral("1 shot, 1 hit")), qPrintable(run.out + run.err));
        }
    }

    void hugeMeshesAreReadBack() {
        const QString mesh = writeBytes(in("huge.obj"), sheetObj(-5.0e19, 1.0e20));
        for (const char* suffix : {"glb", "ply", "stl", "obj"}) {
            const CliRun run = runCli({"convert", "--check", mesh, in(QStringLiteral("copy.") + suffix)});
            QVERIFY2(run.status == 0, qPrintable(run.err));
        }
    }

    void whatDrawsNothingNeedsNoOpenGL() {
        const QString mesh = writeBytes(in("a.obj"), sheetObj(0.0, 1.0));
        const std::vector<std::pair<QString, QString>> without{
            {QStringLiteral("LIBGL_DRIVERS_PATH"), QStringLiteral("/nonexistent")},
            {QStringLiteral("__EGL_VENDOR_LIBRARY_FILENAMES"), QStringLiteral("/nonexistent")}};
        QCOMPARE(runCli({"convert", mesh, in("a.ply")}, without).status, 0);
        QCOMPARE(runCli({"compare", mesh, in("a.ply")}, without).status, 0);
        QCOMPARE(runCli({"section", "--plane", "x=0.3", mesh}, without).status, 0);
        // Hits are applied by the reference then, and the results are those of the usual pipeline.
        const CliRun with = runCli({"shoot", mesh, "--session", in("with.hitscope")});
        const CliRun run = runCli({"shoot", mesh, "--session", in("a.hitscope")}, without);
        QCOMPARE(run.status, 0);
        QVERIFY2(run.err.contains(QStringLiteral("Using the reference instead")), qPrintable(run.err));
        QVERIFY2(run.out.contains(QStringLiteral("Reference: as every hit at every vertex")),
                 qPrintable(run.out));
        const auto fingerprints = [](const CliRun& one) {
            return QString(one.out)
                .replace(QStringLiteral("Transform feedback"), QStringLiteral("Reference"))
                .split(u'\n')
                .filter(QStringLiteral("fingerprint"));
        };
        QCOMPARE(fingerprints(run), fingerprints(with));
        QCOMPARE(fingerprints(run).size(), 2);
        QFile saved(in("a.hitscope"));
        QVERIFY(saved.open(QIODevice::ReadOnly));
        const QJsonObject document = QJsonDocument::fromJson(saved.readAll()).object();
        QCOMPARE(document["simulation"].toObject()["pipeline"].toString(),
                 QStringLiteral("transform-feedback"));
        for (const QStringList& verb : {QStringList{"info"},
                                        {"replay"},
                                        {"changes"},
                                        {"dents"},
                                        {"section", "--plane", "x=0.3"},
                                        {"explain", "--vertex", "1"},
                                        {"export", "--out", in("b.obj")}}) {
            for (const QString& session : {in("a.hitscope"), in("with.hitscope")}) {
                const CliRun one = runCli(verb + QStringList{session}, without);
                QVERIFY2(one.status == 0, qPrintable(verb[0] + one.err));
            }
        }
        const CliRun asked = runCli({"replay", "--pipeline", "compute", in("a.hitscope")}, without);
        QCOMPARE(asked.status, 4);
        QVERIFY2(asked.err.contains(QStringLiteral("--pipeline reference")), qPrintable(asked.err));
        QCOMPARE(runCli({"shoot", mesh, "--picture", in("a.png")}, without).status, 4);
        QCOMPARE(runCli({"verify", in("a.hitscope")}, without).status, 4);
    }

    void badFilesKeepNobodyFromOthers() {
        const QString good = writeBytes(in("good.obj"), sheetObj(0.0, 1.0));
        const QString bad = writeBytes(in("bad.obj"), "v 0 0 0\nf 1 2 3\n");
        const CliRun run = runCli({"info", good, bad, good});
        QCOMPARE(run.status, 3);
        QCOMPARE(run.out.count(QStringLiteral("good.obj")), 2);
        QVERIFY2(run.err.contains(QStringLiteral("bad.obj")), qPrintable(run.err));
        const QJsonObject report = jsonOf(runCli({"info", "--json", good, bad}));
        QCOMPARE(report["files"].toArray().size(), 1);
        const QJsonArray failed = report["failed"].toArray();
        QCOMPARE(failed.size(), 1);
        QCOMPARE(failed[0].toObject()["file"].toString(), bad);
        QVERIFY(!failed[0].toObject()["error"].toString().isEmpty());
    }

    /// Another name would be written.
    void namesThatAreNoTextAreRefused() {
        const QString mesh = writeBytes(in("a.obj"), sheetObj(0.0, 1.0));
        QProcess shell;
        shell.start(QStringLiteral("sh"),
                    {"-c", R"sh("$HITSCOPE_CLI" convert "$1" "$(printf "$2/n\377.ply")")sh", "sh", mesh,
                     m_folder.path()});
        QVERIFY(shell.waitForFinished());
        QCOMPARE(shell.exitCode(), 3);
        QVERIFY(shell.readAllStandardError().contains("not UTF-8"));
        QVERIFY(QDir(m_folder.path()).entryList({QStringLiteral("n*")}).isEmpty());
    }
};

HITSCOPE_TEST(PlacedMeshesTest, QCoreApplication)

}  // namespace hitscope::placed_meshes_test

#include "placed_meshes_test.moc"
