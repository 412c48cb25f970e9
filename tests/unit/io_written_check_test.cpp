// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTemporaryDir>
#include <QTest>
#include <cstring>

#include "io/check/written_check.h"
#include "io/export_obj.h"
#include "support/test_program.h"
#include "write_support.h"

namespace hitscope::io_written_check_test {

using namespace test;

namespace {

const char* const kSource =
    "v 0.125 0 0\nv 1.5 0 0\nv 1 1 0\nv 0 1 0\nv 7 7.75 7\no one\nf 1 2 3 4\nf 1 3 2\nf 4 3 1\n";

const char* const kLoose = "l 1 2 5\np 3\n";

// A corner without texture coordinate and one without normal are in it.
const char* const kPainted =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0.125 0.25\nvt 0.5 0.375\nvt 0.75 0.875\nvn 0 0 1\nvn 0 3 0\n"
    "usemtl red\nf 1/1/1 2/2/1 3/3/1\nusemtl blue\nf 1/1/2 3/3/2 4/2/2\n";
const char* const kPartlyPainted =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0.125 0.25\nvn 0 0 1\nf 1/1 2//1 3/1/1\nusemtl blue\nf 1 3 4\n";

/// Exports to a file of that suffix.
QString write(const DentedFile& mesh, const QString& suffix, const QTemporaryDir& folder) {
    const QString path = folder.filePath(QStringLiteral("written.") + suffix);
    const MeshExport what = mesh.what();
    bool isWritten = false;
    if (suffix == QStringLiteral("obj")) {
        ObjExport file;
        file.mesh = what.mesh;
        file.positions = what.positions;
        file.normals = {what.normals, {}};
        file.sourcePath = mesh.sourcePath;
        file.sourceFolder = QFileInfo(mesh.sourcePath).absolutePath();
        isWritten = exportObj(file, path).ok();
    } else if (suffix == QStringLiteral("ply")) {
        isWritten = exportPly(what, path, {.encoding = PlyOptions::Encoding::Ascii}).ok();
    } else if (suffix == QStringLiteral("stl")) {
        isWritten = exportStl(what, path, {.isAscii = true}).ok();
    } else {
        isWritten = exportGltf(what, path, {}).ok();
    }
    return isWritten ? path : QString();
}

/// Those of the file, and that of the first corner is turned.
void giveNormals(DentedFile& file) {
    const MeshData& mesh = file.original.mesh;
    for (const std::uint32_t normal : mesh.cornerNormals) {
        file.normals.push_back(normal == kNoIndex ? glm::vec3(0, 1, 0)
                                                  : glm::normalize(mesh.normals[normal]));
    }
    file.normals.front() = {1, 0, 0};
}

std::string bytesOf(float number) {
    std::string bytes;
    put(bytes, number);
    return bytes;
}

class TestIoWrittenCheck : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void soundFilesPass_data() {
        QTest::addColumn<QString>("suffix");
        for (const char* const suffix : {"obj", "ply", "stl", "glb", "gltf"}) {
            QTest::newRow(suffix) << QString::fromLatin1(suffix);
        }
    }
    void soundFilesPass() {
        QFETCH(QString, suffix);
        QTemporaryDir folder;
        DentedFile mesh(writeFile(folder.path(), QStringLiteral("a.obj"), kSource));
        mesh.move(1, {0.0f, 0.0f, -1.75f});
        const Status same = verifyWritten(write(mesh, suffix, folder), mesh.what());
        QVERIFY2(same, qPrintable(messageOf(same)));
        place(mesh.original.mesh, 0.5f);
        mesh.positions.assign(mesh.original.mesh.positions.begin(), mesh.original.mesh.positions.end());
        mesh.move(1, {0.0f, 0.0f, -0.3f});
        const Status placed = verifyWritten(write(mesh, suffix, folder), mesh.what());
        QVERIFY2(placed, qPrintable(messageOf(placed)));
    }

    void soundSurfacesPass_data() {
        QTest::addColumn<QString>("suffix");
        QTest::addColumn<bool>("isAnew");
        for (const char* const suffix : {"obj", "ply", "glb", "gltf"}) {
            QTest::addRow("%s", suffix) << QString::fromLatin1(suffix) << false;
            QTest::addRow("%s, written anew", suffix) << QString::fromLatin1(suffix) << true;
        }
    }
    void soundSurfacesPass() {
        QFETCH(QString, suffix);
        QFETCH(bool, isAnew);
        for (const char* const source : {kPainted, kPartlyPainted}) {
            QTemporaryDir folder;
            DentedFile mesh(writeFile(folder.path(), QStringLiteral("a.obj"), source));
            mesh.move(0, {0.0f, 0.0f, -1.75f});
            giveNormals(mesh);
            mesh.sourcePath = isAnew ? QString() : mesh.sourcePath;
            const Status same = verifyWritten(write(mesh, suffix, folder), mesh.what());
            QVERIFY2(same, qPrintable(messageOf(same)));
        }
    }

    void brokenSurfacesAreFound_data() {
        QTest::addColumn<QString>("suffix");
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, const char* suffix, const std::string& from,
                            const std::string& to, const char* says) {
            QTest::newRow(name) << QString::fromLatin1(suffix) << QByteArray::fromStdString(from)
                                << QByteArray::fromStdString(to) << QString::fromLatin1(says);
        };
        row("obj, normal that turned", "obj", "vn 1 0 0", "vn 0.99 0 0.1",
            "corner 1 of face 1 has the normal 0.99 0 0.1 and should have 1 0 0");
        row("obj, normal that stayed", "obj", "vn 0 3 0", "vn 0 3 0.1", "corner 1 of face 2");
        row("obj, another normal", "obj", "3/3/2 4", "3/3/1 4", "corner 2 of face 2 has the normal");
        row("obj, no normal", "obj", "3/3/2 4", "3/3 4", "corner 2 of face 2 has no normal");
        row("obj, texture coordinate", "obj", "vt 0.5 0.375", "vt 0.5 0.374",
            "corner 2 of face 1 has the texture coordinate 0.5 0.374 and should have 0.5 0.375");
        row("obj, no texture coordinate", "obj", "3/3/2 4", "3//2 4",
            "corner 2 of face 2 has no texture coordinate");
        row("obj, material", "obj", "usemtl blue", "usemtl green",
            "face 2 has the material \"green\" and should have \"blue\"");
        row("ply, texture coordinate", "ply", "0.375", "0.374", "texture coordinate");
        row("glb, texture coordinate", "glb", bytesOf(1.0f - 0.875f), bytesOf(0.25f), "texture coordinate");
        const std::string upwards = bytesOf(0.0f) + bytesOf(0.0f) + bytesOf(1.0f);
        row("glb, normal", "glb", upwards + upwards + upwards,
            bytesOf(0.0f) + bytesOf(1.0f) + bytesOf(0.0f) + upwards + upwards, "has the normal 0 1 0");
        row("glb, normal that turned", "glb", bytesOf(1.0f) + bytesOf(0.0f) + bytesOf(-1.0f),
            bytesOf(1.0f) + bytesOf(0.0f) + bytesOf(-0.5f), "normal, deformed");
        row("glb, material", "glb", "\"material\":1", "\"material\":0", "material");
    }
    void brokenSurfacesAreFound() {
        QFETCH(QString, suffix);
        QFETCH(QByteArray, from);
        QFETCH(QByteArray, to);
        QFETCH(QString, says);
        QTemporaryDir folder;
        DentedFile mesh(writeFile(folder.path(), QStringLiteral("a.obj"), kPainted));
        mesh.move(0, {0.0f, 0.0f, -1.75f});
        giveNormals(mesh);
        const QString path = write(mesh, suffix, folder);
        QVERIFY(verifyWritten(path, mesh.what()));
        QByteArray bytes = QByteArray::fromStdString(readFile(path));
        QVERIFY2(bytes.contains(from), bytes.constData());
        bytes.replace(bytes.indexOf(from), from.size(), to);
        writeFile(folder.path(), QFileInfo(path).fileName(), bytes.toStdString());
        const Status same = verifyWritten(path, mesh.what());
        QVERIFY(!same);
        QVERIFY2(messageOf(same).contains(says), qPrintable(messageOf(same)));
    }

    void brokenLinesAreFound_data() {
        QTest::addColumn<QString>("suffix");
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, const char* suffix, const std::string& from,
                            const std::string& to, const char* says) {
            QTest::newRow(name) << QString::fromLatin1(suffix) << QByteArray::fromStdString(from)
                                << QByteArray::fromStdString(to) << QString::fromLatin1(says);
        };
        row("obj, line", "obj", "l 1 2 5", "l 1 3 5", "segment 1 of the lines");
        row("obj, shorter line", "obj", "l 1 2 5", "l 1 2", "segments of lines");
        row("obj, point", "obj", "p 3", "p 2", "points");
        row("ply, edge", "ply", "\n1 4\n", "\n1 3\n", "segment 2 of the lines");
        row("ply, other element", "ply", "element edge", "element seam", "segments of lines");
        const std::string indices("\0\0\1\0\1\0\2\0", 8);
        row("glb, line", "glb", indices, std::string("\0\0\1\0\2\0\2\0", 8), "line 2 of object 1");
        row("glb, points instead", "glb", "\"mode\":1", "\"mode\":0", "other lines");
        row("glb, no points", "glb", "\"mode\":0", "\"mode\":1", "other points");
    }
    void brokenLinesAreFound() {
        QFETCH(QString, suffix);
        QFETCH(QByteArray, from);
        QFETCH(QByteArray, to);
        QFETCH(QString, says);
        QTemporaryDir folder;
        DentedFile mesh(writeFile(folder.path(), QStringLiteral("a.obj"), kSource + std::string(kLoose)));
        mesh.move(1, {0.0f, 0.0f, -1.75f});
        const QString path = write(mesh, suffix, folder);
        const Status sound = verifyWritten(path, mesh.what());
        QVERIFY2(sound, qPrintable(messageOf(sound)));
        QByteArray bytes = QByteArray::fromStdString(readFile(path));
        QVERIFY2(bytes.contains(from), "nothing to break");
        bytes.replace(bytes.lastIndexOf(from), from.size(), to);
        writeFile(folder.path(), QFileInfo(path).fileName(), bytes.toStdString());
        const Status same = verifyWritten(path, mesh.what());
        QVERIFY(!same);
        QVERIFY2(messageOf(same).contains(says), qPrintable(messageOf(same)));
    }

    void plyNormalsAreLookedAt() {
        QTemporaryDir folder;
        DentedFile mesh(writeFile(folder.path(), QStringLiteral("a.obj"), kSource));
        mesh.move(1, {0.0f, 0.0f, -1.75f});
        mesh.normals.assign(mesh.original.mesh.cornerVertices.size(), glm::vec3(0.0f, 0.6f, 0.8f));
        const QString path = write(mesh, QStringLiteral("ply"), folder);
        QVERIFY(verifyWritten(path, mesh.what()));
        std::string text = readFile(path);
        const std::size_t at = text.find("0.6");
        QVERIFY(at != std::string::npos);
        writeFile(folder.path(), QStringLiteral("written.ply"), text.replace(at, 3, "0.7"));
        const Status same = verifyWritten(path, mesh.what());
        QVERIFY(!same);
        QVERIFY2(messageOf(same).contains(QStringLiteral("has the normal 0 0.7 0.8")),
                 qPrintable(messageOf(same)));
    }

    void binaryStlNormalsAreLookedAt() {
        QTemporaryDir folder;
        DentedFile mesh(writeFile(folder.path(), QStringLiteral("a.obj"), kSource));
        mesh.move(1, {0.0f, 0.0f, -1.75f});
        const QString path = folder.filePath(QStringLiteral("written.stl"));
        QVERIFY(exportStl(mesh.what(), path));
        const Status sound = verifyWritten(path, mesh.what());
        QVERIFY2(sound, qPrintable(messageOf(sound)));
        std::string bytes = readFile(path);
        bytes[84 + 2 * 50 + 3] = static_cast<char>(bytes[84 + 2 * 50 + 3] ^ 1);  // an exponent
        writeFile(folder.path(), QStringLiteral("written.stl"), bytes);
        const Status same = verifyWritten(path, mesh.what());
        QVERIFY(!same);
        QVERIFY2(messageOf(same).contains(QStringLiteral("triangle 3 has the normal")),
                 qPrintable(messageOf(same)));
    }

    /// A vertex of a PLY file has the normal of the first corner that turned.
    void plyNormalWithoutDirectionPasses() {
        QTemporaryDir folder;
        DentedFile mesh(writeFile(
            folder.path(), QStringLiteral("a.ply"),
            "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
            "property float nx\nproperty float ny\nproperty float nz\nelement face 2\n"
            "property list uchar int vertex_indices\nend_header\n"
            "0 0 0 0 0 0\n1 0 0 0 0 1\n1 1 0 0 0 1\n0 1 0 0 0 2\n3 0 1 2\n3 0 2 3\n"));
        mesh.normals.assign(6, glm::vec3(0, 0, 1));
        mesh.normals[0] = {1, 0, 0};
        mesh.normals[3] = {0, 1, 0};
        const QString path = write(mesh, QStringLiteral("ply"), folder);
        const Status same = verifyWritten(path, mesh.what());
        QVERIFY2(same, qPrintable(messageOf(same)));
        std::string text = readFile(path);
        const std::size_t at = text.find("0 0 0 1 0 0");
        QVERIFY(at != std::string::npos);
        writeFile(folder.path(), QStringLiteral("written.ply"), text.replace(at, 11, "0 0 0 0 1 0"));
        QVERIFY(!verifyWritten(path, mesh.what()));
    }

    void brokenFilesAreFound_data() {
        QTest::addColumn<QString>("suffix");
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, const char* suffix, const std::string& from,
                            const std::string& to, const char* says) {
            QTest::newRow(name) << QString::fromLatin1(suffix) << QByteArray::fromStdString(from)
                                << QByteArray::fromStdString(to) << QString::fromLatin1(says);
        };
        row("obj, moved", "obj", "-1.75", "-1.76", "vertex 2");
        row("obj, still", "obj", "7.75", "7.7500005", "vertex 5");
        row("obj, face", "obj", "f 1 3 2", "f 1 2 3", "face 2");
        row("obj, fewer faces", "obj", "f 4 3 1\n", "", "faces");
        row("obj, fewer vertices", "obj", "v 7 7.75 7\n", "", "vertices");
        row("obj, cut", "obj", "f 1 3 2\n", "f 1 3 99\n", "read");
        row("ply, moved", "ply", "-1.75", "-1.76", "vertex 2");
        row("ply, face", "ply", "3 0 2 1", "3 0 1 2", "face 2");
        row("ply, cut", "ply", "3 3 2 0\n", "", "read");
        row("stl, moved", "stl", "-1.75", "-1.76", "triangle 1");
        row("stl, normal", "stl", "facet normal -", "facet normal ", "triangle 3 has the normal 0.6");
        row("stl, no normal", "stl", "facet normal", "facet abnormal", "triangle 1 has no normal");
        row("stl, fewer", "stl", "endsolid",
            "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
            "0\nendloop\nendfacet\nendsolid",
            "triangles");
        row("glb, original", "glb", bytesOf(7.75f), bytesOf(7.5f), "vertex 5");
        row("glb, moved", "glb", bytesOf(-1.75f), bytesOf(-1.5f), "vertex 2");
        row("glb, another shown", "glb", "\"weights\":[1]", "\"weights\":[0]", "shown");
        row("glb, another name", "glb", "Deformed", "deformed", "shown");
        row("glb, cut", "glb", "\"asset\"", "\"esset\"", "read");
        row("gltf, face", "gltf.bin", std::string("\0\0\2\0\1\0", 6), std::string("\0\0\1\0\2\0", 6),
            "face 2");
    }
    void brokenFilesAreFound() {
        QFETCH(QString, suffix);
        QFETCH(QByteArray, from);
        QFETCH(QByteArray, to);
        QFETCH(QString, says);
        QTemporaryDir folder;
        DentedFile mesh(writeFile(folder.path(), QStringLiteral("a.obj"), kSource));
        mesh.move(1, {0.0f, 0.0f, -1.75f});
        const QString path = write(mesh, suffix.section(u'.', 0, 0), folder);
        QVERIFY(verifyWritten(path, mesh.what()));
        const QString broken = suffix.contains(u'.') ? folder.filePath(QStringLiteral("written.bin")) : path;
        QByteArray bytes = QByteArray::fromStdString(readFile(broken));
        QVERIFY2(bytes.contains(from), "nothing to break");
        bytes.replace(bytes.indexOf(from), from.size(), to);
        writeFile(folder.path(), QFileInfo(broken).fileName(), bytes.toStdString());
        const Status same = verifyWritten(path, mesh.what());
        QVERIFY(!same);
        QVERIFY2(messageOf(same).contains(says), qPrintable(messageOf(same)));
        QVERIFY(messageOf(same).contains(QStringLiteral("written.")));
    }
};

}  // namespace

HITSCOPE_TEST(TestIoWrittenCheck, QCoreApplication)

}  // namespace hitscope::io_written_check_test

#include "io_written_check_test.moc"
