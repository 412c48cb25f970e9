// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTemporaryDir>
#include <QTest>
#include <cstring>

#include "io/export_obj.h"
#include "io/written_check.h"
#include "support/test_program.h"
#include "write_support.h"

namespace hitscope::io_written_check_test {

using namespace test;

namespace {

const char* const kSource =
    "v 0.125 0 0\nv 1.5 0 0\nv 1 1 0\nv 0 1 0\nv 7 7.75 7\no one\nf 1 2 3 4\nf 1 3 2\nf 4 3 1\n";

/// Exports to a file of that suffix.
QString write(const DentedFile& mesh, const QString& suffix, const QTemporaryDir& folder) {
    const QString path = folder.filePath(QStringLiteral("written.") + suffix);
    const MeshExport what = mesh.what();
    bool isWritten = false;
    if (suffix == QStringLiteral("obj")) {
        ObjExport file;
        file.mesh = what.mesh;
        file.positions = what.positions;
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
        mesh.positions = mesh.original.mesh.positions;
        mesh.move(1, {0.0f, 0.0f, -0.3f});
        const Status placed = verifyWritten(write(mesh, suffix, folder), mesh.what());
        QVERIFY2(placed, qPrintable(messageOf(placed)));
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
