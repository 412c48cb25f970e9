// SPDX-License-Identifier: GPL-3.0-or-later
// The check of what was written: MTL files, their pictures, and the picture that a PLY names.
#include <QDir>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

#include "io/check/written_check.h"
#include "io/export_obj.h"
#include "support/test_program.h"
#include "write_support.h"

namespace hitscope::io_written_materials_test {

using namespace test;

namespace {

const char* const kObj =
    "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl red\nf 1/1 2/2 3/3\n"
    "usemtl plain\nf 4/1 3/2 2/3\n";
const char* const kMtl =
    "# of its own\nnewmtl red\nKa 0.1 0.2 0.3\nKd 0.5 0.25 0.125\nKs 0.3 0.3 0.3\nNs 33\nd 0.5\nPr 0.75\nPm "
    "0.625\n"
    "map_Kd wood.png\nnorm -bm 0.75 bumps.png\nnewmtl plain\nKd 1 1 1\n";

/// A mesh with an MTL file and pictures, and where it is exported to.
struct Painted {
    QTemporaryDir folder;
    DentedFile mesh;

    explicit Painted(bool isAnew) : mesh(write()) {
        mesh.move(1, {0.0f, 0.0f, 0.5f});
        if (isAnew) {
            mesh.original.mesh.materialLibraries.clear();
            mesh.original.mesh.sourceHash = 0;
        }
    }
    QString write() {
        QDir(folder.path()).mkdir(QStringLiteral("out"));
        writeFile(folder.path(), QStringLiteral("a.mtl"), kMtl);
        writeFile(folder.path(), QStringLiteral("wood.png"), smallPng().toStdString());
        writeFile(folder.path(), QStringLiteral("bumps.png"), smallPng().toStdString());
        return writeFile(folder.path(), QStringLiteral("a.obj"), kObj);
    }
    [[nodiscard]] QString out(const QString& name) const {
        return folder.filePath(QStringLiteral("out/") + name);
    }
    /// Exports to out/b.obj.
    [[nodiscard]] bool writeOut() const {
        ObjExport file;
        file.mesh = &mesh.original.mesh;
        file.positions = mesh.positions;
        file.sourcePath = mesh.sourcePath;
        file.sourceFolder = folder.path();
        return exportObj(file, out(QStringLiteral("b.obj"))).ok();
    }
    [[nodiscard]] Status verify() const { return verifyWritten(out(QStringLiteral("b.obj")), mesh.what()); }
};

class TestIoWrittenMaterials : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void soundOnesPass_data() {
        QTest::addColumn<bool>("isAnew");
        QTest::newRow("copied") << false;
        QTest::newRow("written anew") << true;
    }
    void soundOnesPass() {
        QFETCH(const bool, isAnew);
        const Painted painted(isAnew);
        QVERIFY(painted.mesh.original.mesh.materials.front().normalMap.image >= 0);
        QVERIFY(painted.writeOut());
        QVERIFY(QFileInfo::exists(painted.out(QStringLiteral("wood.png"))));
        const Status same = painted.verify();
        QVERIFY2(same, qPrintable(messageOf(same)));
    }

    void renamedPicturesPass() {
        const Painted painted(false);
        writeFile(painted.out({}), QStringLiteral("wood.png"), "something else");
        QVERIFY(painted.writeOut());
        QVERIFY(readFile(painted.out(QStringLiteral("a.mtl"))).find("wood-1.png") != std::string::npos);
        const Status same = painted.verify();
        QVERIFY2(same, qPrintable(messageOf(same)));
    }

    void brokenOnesAreFound_data() {
        QTest::addColumn<bool>("isAnew");
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, bool isAnew, const char* from, const char* to,
                            const char* says) {
            QTest::newRow(name) << isAnew << QByteArray(from) << QByteArray(to) << QString::fromLatin1(says);
        };
        const char* const kNotThere = "the material file \"a.mtl\" is not there as it is";
        row("copied, another number", false, "Ns 33", "Ns 32", kNotThere);
        row("copied, a comment", false, "of its own", "of its town", kNotThere);
        row("copied, another map", false, "map_Kd wood", "map_Ks wood", kNotThere);
        row("copied, cut", false, "newmtl plain\nKd 1 1 1\n", "", kNotThere);
        row("copied, no picture", false, "map_Kd wood.png", "map_Kd food.png", "\"red\" has another texture");
        row("anew, ambient", true, "Ka 0.1 0.2 0.3", "Ka 0.1 0.2 0.4", "\"red\" has another colour");
        row("anew, diffuse", true, "Kd 0.5 0.25 0.125", "Kd 0.5 0.25 0.12", "\"red\" has another colour");
        row("anew, second material", true, "Kd 1 1 1", "Kd 1 0 1", "\"plain\" has another colour");
        row("anew, specular", true, "Ks 0.3", "Ks 0.2", "another colour");
        row("anew, shininess", true, "Ns 33", "Ns 32", "another shininess");
        row("anew, opacity", true, "\nd 0.5", "\nd 0.75", "another opacity");
        row("anew, roughness", true, "Pr 0.75", "Pr 0.7", "another metalness or roughness");
        row("anew, metalness", true, "Pm 0.625", "Pm 0.6", "another metalness or roughness");
        row("anew, not metallic", true, "Pr 0.75\nPm 0.625\n", "", "another metalness or roughness");
        row("anew, strength", true, "-bm 0.75", "-bm 0.5", "another strength of its normal map");
        row("anew, no texture", true, "map_Kd wood.png\n", "", "\"red\" has another texture");
        row("anew, no normal map", true, "norm -bm 0.75 bumps.png\n", "", "another normal map");
    }
    void brokenOnesAreFound() {
        QFETCH(const bool, isAnew);
        QFETCH(const QByteArray, from);
        QFETCH(const QByteArray, to);
        QFETCH(const QString, says);
        const Painted painted(isAnew);
        QVERIFY(painted.writeOut());
        const QString name = isAnew ? QStringLiteral("b.mtl") : QStringLiteral("a.mtl");
        QByteArray bytes = QByteArray::fromStdString(readFile(painted.out(name)));
        QVERIFY2(bytes.contains(from), bytes.constData());
        writeFile(painted.out({}), name, bytes.replace(from, to).toStdString());
        const Status same = painted.verify();
        QVERIFY(!same);
        QVERIFY2(messageOf(same).contains(says), qPrintable(messageOf(same)));
    }

    void anotherPictureIsFound() {
        const Painted painted(false);
        QVERIFY(painted.writeOut());
        QImage image(2, 2, QImage::Format_RGB32);
        image.fill(Qt::blue);
        QVERIFY(image.save(painted.out(QStringLiteral("wood.png"))));
        QVERIFY(messageOf(painted.verify()).contains(QStringLiteral("\"red\" has another texture")));
    }

    void aPlyNamesItsPicture_data() {
        QTest::addColumn<bool>("isAnew");
        QTest::newRow("copied") << false;
        QTest::newRow("written anew") << true;
    }
    void aPlyNamesItsPicture() {
        QFETCH(const bool, isAnew);
        QTemporaryDir folder;
        DentedFile mesh(writeFile(
            folder.path(), QStringLiteral("a.ply"),
            "ply\nformat ascii 1.0\ncomment TextureFile wood.png\nelement vertex 3\nproperty float x\n"
            "property float y\nproperty float z\nproperty float s\nproperty float t\nelement face 1\n"
            "property list uchar int vertex_indices\nend_header\n0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 "
            "2\n"));
        mesh.sourcePath = isAnew ? QString() : mesh.sourcePath;
        const QString path = folder.filePath(QStringLiteral("b.ply"));
        QVERIFY(exportPly(mesh.what(), path, {.encoding = PlyOptions::Encoding::Ascii}));
        const Status sound = verifyWritten(path, mesh.what());
        QVERIFY2(sound, qPrintable(messageOf(sound)));
        for (const char* const other : {"comment TextureFile food.png", "comment texturefile wood.png"}) {
            QByteArray bytes = QByteArray::fromStdString(readFile(path));
            bytes.replace("comment TextureFile wood.png", other);
            writeFile(folder.path(), QStringLiteral("c.ply"), bytes.toStdString());
            const Status same = verifyWritten(folder.filePath(QStringLiteral("c.ply")), mesh.what());
            QVERIFY(!same);
            QVERIFY2(messageOf(same).contains(QStringLiteral("should name \"wood.png\"")),
                     qPrintable(messageOf(same)));
        }
    }
};

}  // namespace

HITSCOPE_TEST(TestIoWrittenMaterials, QCoreApplication)

}  // namespace hitscope::io_written_materials_test

#include "io_written_materials_test.moc"
