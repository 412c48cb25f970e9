// SPDX-License-Identifier: GPL-3.0-or-later
// What a mesh keeps on its way from one file to another, in a folder of its own.
#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <memory>

#include "io/import.h"
#include "io/mtl_lines.h"
#include "io/writers/mesh_export.h"
#include "io_support.h"
#include "session/export/export_target.h"
#include "session/session.h"
#include "support/test_program.h"

namespace hitscope::io_exchange_test {

using namespace test;

namespace {

const char* const kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n";

}  // namespace

class IoExchangeTest : public QObject {
    Q_OBJECT
private:
    std::unique_ptr<QTemporaryDir> m_folder;

    [[nodiscard]] QString in(const QString& name) const { return m_folder->filePath(name); }
    QString write(const QString& name, const std::string& content) const {
        QDir().mkpath(QFileInfo(in(name)).absolutePath());
        return writeFile(m_folder->path(), name, content);
    }
    [[nodiscard]] static ImportedMesh read(const QString& path) {
        const Result<ImportedMesh> mesh = importMesh(path);
        if (!mesh) {
            qFatal("%s", mesh.error().message().c_str());
        }
        return mesh.value();
    }
    /// Reads one file and writes another, in a folder beside it; the notes.
    QStringList convert(const QString& from, const QString& to, bool readBack = true) const {
        QDir().mkpath(QFileInfo(in(to)).absolutePath());
        Session session;
        loadMesh(session, read(in(from)).mesh, in(from));
        ExportOptions options;
        options.format = exportFormatOf(to).value();
        options.readBack = readBack;
        const Result<ExportReport> written =
            exportTarget(session, *session.targets().front(), in(to), options);
        return written ? written.value().notes : QStringList{messageOf(written)};
    }
    void writeTextured() const {
        write(QStringLiteral("a.png"), smallPng().toStdString());
        write(QStringLiteral("a.mtl"), "newmtl wood\nKd 1 1 1\nmap_Kd a.png\n");
        write(QStringLiteral("a.obj"),
              std::string("mtllib a.mtl\n") + kTriangle + "usemtl wood\nf 1/1 2/2 3/3\n");
    }

private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void aPlyGetsItsPicture_data() {
        QTest::addColumn<bool>("isTaken");
        QTest::addColumn<QString>("name");
        QTest::newRow("by its name") << false << QStringLiteral("a.png");
        QTest::newRow("where another has that name") << true << QStringLiteral("a-1.png");
    }
    void aPlyGetsItsPicture() {
        QFETCH(bool, isTaken);
        QFETCH(QString, name);
        writeTextured();
        for (const QString& folder : {QStringLiteral("one/"), QStringLiteral("two/")}) {
            if (isTaken) {
                write(folder + QStringLiteral("a.png"), "another's");
            }
        }
        QCOMPARE(convert(QStringLiteral("a.obj"), QStringLiteral("one/b.ply")),
                 QStringList{QStringLiteral("Also written beside it: %1.").arg(name)});
        QCOMPARE(read(in(QStringLiteral("one/b.ply"))).mesh.images.size(), std::size_t{1});
        // And a copy of that PLY.
        QCOMPARE(convert(QStringLiteral("one/b.ply"), QStringLiteral("two/c.ply")).last(),
                 QStringLiteral("Also written beside it: %1.").arg(name));
        QCOMPARE(read(in(QStringLiteral("two/c.ply"))).mesh.images.size(), std::size_t{1});
    }

    void aPlyWithoutTextureCoordinatesNamesNone() {
        writeTextured();
        write(QStringLiteral("a.obj"), std::string("mtllib a.mtl\n") + kTriangle + "usemtl wood\nf 1 2 3\n");
        QCOMPARE(convert(QStringLiteral("a.obj"), QStringLiteral("out/b.ply")),
                 QStringList{QStringLiteral("PLY has no materials; they are left out.")});
        QVERIFY(!QFile::exists(in(QStringLiteral("out/a.png"))));
    }

    void aPlySaysWhatItLeavesOut() {
        writeTextured();
        write(QStringLiteral("a.mtl"), "newmtl wood\nKd 1 0 0\nmap_Kd a.png\n");
        write(QStringLiteral("a.obj"),
              std::string("mtllib a.mtl\n") + kTriangle + "usemtl wood\nf 1/1 2/2 3/3\np 2\n");
        const QString notes =
            convert(QStringLiteral("a.obj"), QStringLiteral("out/b.ply")).join(QLatin1Char(' '));
        QVERIFY2(notes.contains(QStringLiteral("texture of a material alone")), qPrintable(notes));
        QVERIFY2(notes.contains(QStringLiteral("no point elements")), qPrintable(notes));
    }

    void librariesOfAnyLayoutGoAlong_data() {
        QTest::addColumn<QByteArray>("library");
        QTest::newRow("indented") << QByteArray("# mine\n  newmtl wood\n  Kd 1 0 0\n");
        QTest::newRow("tab") << QByteArray("newmtl\twood\nKd 1 0 0\n");
        QTest::newRow("byte order mark") << QByteArray("\xef\xbb\xbfnewmtl wood\nKd 1 0 0\n");
        QTest::newRow("carriage returns") << QByteArray("newmtl wood\rKd 1 0 0\r");
        QTest::newRow("both line ends") << QByteArray("newmtl wood\r\nKd 1 0 0\r\n");
    }
    void librariesOfAnyLayoutGoAlong() {
        QFETCH(QByteArray, library);
        QVERIFY(definesMaterials(library.toStdString()));
        write(QStringLiteral("a.mtl"), library.toStdString());
        write(QStringLiteral("a.obj"), std::string("mtllib a.mtl\n") + kTriangle + "usemtl wood\nf 1 2 3\n");
        const QStringList notes = convert(QStringLiteral("a.obj"), QStringLiteral("out/b.obj"));
        QCOMPARE(notes, QStringList{QStringLiteral("Also written beside it: a.mtl.")});
        const ImportedMesh again = read(in(QStringLiteral("out/b.obj")));
        QCOMPARE(again.notes, QStringList());
        QCOMPARE(again.mesh.materials.size(), std::size_t{1});
        QVERIFY(again.mesh.materials[0].diffuse == glm::vec3(1.0f, 0.0f, 0.0f));
        QVERIFY(!definesMaterials("# newmtl wood\nnewmtl \n"));
    }

    /// Pictures beside a library in a folder below, with one whose place is taken.
    void texturesBesideTheirLibrary() {
        write(QStringLiteral("sub/a.png"), smallPng().toStdString());
        write(QStringLiteral("sub/a.mtl"), "newmtl wood\nKd 1 1 1\nmap_Kd a.png\n");
        write(QStringLiteral("a.obj"),
              std::string("mtllib sub/a.mtl\n") + kTriangle + "usemtl wood\nf 1/1 2/2 3/3\n");
        QCOMPARE(read(in(QStringLiteral("a.obj"))).notes, QStringList());
        write(QStringLiteral("out/sub/a.png"), "another's");
        convert(QStringLiteral("a.obj"), QStringLiteral("out/b.obj"));
        const ImportedMesh again = read(in(QStringLiteral("out/b.obj")));
        QCOMPARE(again.notes, QStringList());
        QCOMPARE(again.mesh.images.size(), std::size_t{1});
        QCOMPARE(QString::fromStdString(readFile(in(QStringLiteral("out/sub/a.png")))),
                 QStringLiteral("another's"));
        // Nor is another picture taken for it that lies beside the OBJ.
        QImage other(3, 3, QImage::Format_RGB32);
        other.fill(Qt::blue);
        QVERIFY(QDir().mkpath(in(QStringLiteral("two"))) && other.save(in(QStringLiteral("two/a.png"))));
        QCOMPARE(convert(QStringLiteral("a.obj"), QStringLiteral("two/b.obj")),
                 QStringList{QStringLiteral("Also written beside it: sub/a.png, sub/a.mtl.")});
        QCOMPARE(read(in(QStringLiteral("two/b.obj"))).mesh.images.at(0).width, 2);
    }

    void anObjectOfTwoMaterialsStaysOne() {
        write(QStringLiteral("a.mtl"), "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
        write(QStringLiteral("a.obj"), std::string("mtllib a.mtl\no Box\n") + kTriangle +
                                           "v 1 1 0\nusemtl red\nf 1 2 3\nusemtl blue\nf 2 4 3\nl 1 4\n");
        convert(QStringLiteral("a.obj"), QStringLiteral("out/b.glb"));
        const MeshData again = read(in(QStringLiteral("out/b.glb"))).mesh;
        QCOMPARE(again.groups.size(), std::size_t{1});
        QCOMPARE(QString::fromStdString(again.groups[0].name), QStringLiteral("Box"));
        QCOMPARE(again.faceCount(), std::size_t{2});
        QCOMPARE(again.lines.size(), std::size_t{1});
    }

    void namesOfOtherEncodingsAreRead() {
        write(QStringLiteral("a.obj"), std::string("o caf\xe9\n") + kTriangle + "f 1 2 3\n");
        convert(QStringLiteral("a.obj"), QStringLiteral("out/b.glb"));
        const MeshData again = read(in(QStringLiteral("out/b.glb"))).mesh;
        QCOMPARE(QString::fromStdString(again.groups.at(0).name), QStringLiteral("caf\u00e9"));
    }

    void whiteStaysWhite() {
        write(QStringLiteral("a.obj"), "v 0 0 0 1 1 1\nv 1 0 0 1 1 1\nv 0 1 0 0 0 0\nf 1 2 3\n");
        convert(QStringLiteral("a.obj"), QStringLiteral("out/b.glb"));
        const MeshData again = read(in(QStringLiteral("out/b.glb"))).mesh;
        QVERIFY(again.colours.at(0) == glm::vec3(1.0f));
        QVERIFY(again.colours.at(2) == glm::vec3(0.0f));
    }

    void namesAsLongAsTheDiskTakes() {
        write(QStringLiteral("a.obj"), std::string(kTriangle) + "f 1 2 3\n");
        const QString name = QString(81, QChar(0x6f22)) + QStringLiteral(".obj");  // of 247 bytes
        QCOMPARE(convert(QStringLiteral("a.obj"), QStringLiteral("out/") + name, false), QStringList());
        QVERIFY(QFile::exists(in(QStringLiteral("out/") + name)));
    }

    void unitAndAxisOfDaeAreTold() {
        std::string dae =
            readFile(QDir(QStringLiteral(HITSCOPE_TEST_DATA)).filePath(QStringLiteral("quad.dae")));
        QCOMPARE(read(write(QStringLiteral("a.dae"), dae)).notes, QStringList());
        const std::string usual = "meter=\"1\"/><up_axis>Y_UP";
        dae.replace(dae.find(usual), usual.size(), "meter=\"0.01\"/><up_axis>Z_UP");
        const ImportedMesh mesh = read(write(QStringLiteral("b.dae"), dae));
        QCOMPARE(mesh.notes.size(), 2);
        QVERIFY(mesh.notes[0].contains(QStringLiteral("0.01 m")));
        QVERIFY(mesh.notes[1].startsWith(QStringLiteral("z points up")));
        const Bounds bounds = mesh.mesh.bounds();
        QVERIFY(std::abs(bounds.size().x - 0.02f) < 1.0e-6f && bounds.size().y < 1.0e-6f);
    }

    /// What moved less than a float's last digit, far from the file's origin.
    void smallChangesFarAway() {
        MeshData mesh =
            read(write(QStringLiteral("a.obj"), "v 500000 0 0\nv 500001 0 0\nv 500000 1 0\nf 1 2 3\n")).mesh;
        place(mesh, 1.0f);
        std::vector<glm::vec3> moved(mesh.positions.begin(), mesh.positions.end());
        moved[0].x += 1.0e-3f;
        MeshExport what;
        what.mesh = &mesh;
        what.positions = moved;
        QVERIFY(exportChangesCsv(what, in(QStringLiteral("a.csv"))));
        QVERIFY2(readFile(in(QStringLiteral("a.csv"))).find("500000.00") != std::string::npos,
                 readFile(in(QStringLiteral("a.csv"))).c_str());
        QVERIFY(exportPly(what, in(QStringLiteral("a.ply"))));
        const MeshData again = read(in(QStringLiteral("a.ply"))).mesh;
        const double x = again.filePositions.empty() ? static_cast<double>(again.positions[0].x)
                                                     : again.filePositions[0].x;
        QVERIFY2(std::abs(x - 500'000.001) < 1.0e-6, qPrintable(QString::number(x, 'g', 17)));
    }

    void aMeshWithoutANameHasOne() {
        const QString path = write(QStringLiteral(".obj"), std::string(kTriangle) + "f 1 2 3\n");
        QCOMPARE(QString::fromStdString(read(path).mesh.name), QStringLiteral(".obj"));
    }
};

HITSCOPE_TEST(IoExchangeTest, QCoreApplication)

}  // namespace hitscope::io_exchange_test

#include "io_exchange_test.moc"
