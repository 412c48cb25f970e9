// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/stat.h>
#include <unistd.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "core/sanitizers.h"
#include "io/import.h"
#include "io_support.h"
#include "support/test_program.h"

namespace hitscope::io_bad_input_test {

using namespace test;

/// Whatever a file holds, there is one message that says what is wrong, where, and what to do.
class BadInputTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void content_data();
    void content();
    void cutBetweenTriangles();
    void noFile_data();
    void noFile();
    void unreadable();
    void trouble_data();
    void trouble();
    void tooMuchMemory();

private:
    QTemporaryDir m_folder;
};

void BadInputTest::content_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* title, const char* name, const QByteArray& bytes, const char* message) {
        QTest::newRow(title) << name << bytes << message;
    };
    const QByteArray png = smallPng();
    row("empty", "a.obj", "", "a.obj: The file is empty.");
    row("picture as OBJ", "a.obj", png,
        "There are no vertices in it; is this really a file of the format OBJ?");
    row("text as OBJ", "a.obj", "Dear reader,\nvery little here.\n", "There are no vertices in it");
    row("UTF-16 as OBJ", "a.obj", QByteArray::fromHex("fffe76002000300020003000"),
        "a.obj: It is text in UTF-16, in which no OBJ file is written.");
    row("points as OBJ", "a.obj", "v 0 0 0\nv 1 0 0\n",
        "It has 2 vertices but no faces; Hitscope needs a surface.");
    row("cut OBJ", "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2", "a.obj, line 4: The file ends");
    row("index in OBJ", "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 12\n",
        "a.obj, line 4: The face refers to vertex 12, but the file has only 3.");
    row("nan in OBJ", "a.obj", "v 0 0 nan\n", "a.obj, line 1: A coordinate is not a number");
    row("weight 0 in OBJ", "a.obj", "v 0 0 0 0\n", "a.obj, line 1: The weight (w) of a vertex is 0");
    row("weight nan in OBJ", "a.obj", "v 1 0 0\nv 0 0 0 nan 1 1 1\n", "a.obj, line 2: The weight (w)");
    row("colour nan in OBJ", "a.obj", "v 0 0 0 1 nan 1\n", "a.obj, line 1: A colour is infinite or not");
    row("picture as PLY", "a.ply", png, "It does not begin with \"ply\"");
    row("cut PLY", "a.ply", "ply\nformat ascii 1.0\nelement vertex 1000\nproperty float x\n",
        "ends inside its header");
    row("huge PLY", "a.ply",
        "ply\nformat binary_little_endian 1.0\nelement vertex 99999999999\nproperty float x\nproperty float "
        "y\n"
        "property float z\nend_header\n",
        "promises 99999999999 of \"vertex\"");
    row("points as PLY", "a.ply",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
        "end_header\n1 2 3\n",
        "It has 1 vertex but no faces");
    row("picture as STL", "a.stl", png.repeated(3), "triangles, but ends after");
    row("STL cut in a facet", "a.stl", "solid a\nfacet nor", "a.stl, line 2");
    row("cut STL", "a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0",
        "a.stl, line 5");
    row("picture as GLB", "a.glb", png, "It cannot be read as GLB");
    row("cut GLB", "a.glb", QByteArray("glTF\2\0\0\0\xff\xff\0\0\xf0\xff\0\0JSON{\"asset\"", 29), "a.glb");
    row("binary glTF 1.0", "a.glb", QByteArray("glTF\1\0\0\0\x16\0\0\0\2\0\0\0\0\0\0\0{}", 22),
        "It is binary glTF 1.0");
    row("text as glTF", "a.gltf", "{\"asset\":", "It cannot be read as GLTF");
    row("text as DAE", "a.dae", "<COLLADA", "a.dae");
    row("picture as FBX", "a.fbx", png, "a.fbx");
    row("cut FBX", "a.fbx", QByteArray("Kaydara FBX Binary  \0\x1a\0\xe8\x1c\0\0\xff\xff", 29), "a.fbx");
    row("picture as 3DS", "a.3ds", png, "a.3ds");
    row("text as OFF", "a.off", "no off", "a.off: It does not begin as an OFF file.");
    row("binary OFF", "a.off", "OFF BINARY\n", "This kind of OFF (binary, or of another dimension)");
    row("cut OFF", "a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 0 1 \n",
        "The file ends after 3 of its 3 vertices and 1 faces.");
    row("huge OFF", "a.off", "OFF\n3000000000 1 0\n0 0 0\n", "promises 3000000000 vertices");
    row("index in OFF", "a.off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 99\n",
        "a.off, line 5: The face refers to vertex 99 (counted from 0), but the file has 3.");
    row("nan in OFF", "a.off", "OFF\n3 1 0\n0 nan 0\n1 0 0\n0 1 0\n3 0 1 2\n",
        "line 3: A coordinate is not a number");
    row("unknown suffix", "a.blend", "BLENDER", "Hitscope does not know the format .blend.");
    row("no suffix", "mesh", "v 0 0 0\n", "no suffix that tells its format. Hitscope opens .obj, .ply");
}

void BadInputTest::content() {
    QFETCH(QString, name);
    QFETCH(QByteArray, bytes);
    QFETCH(QString, message);
    const QString path = writeFile(m_folder.path(), name, bytes.toStdString());
    const Result<ImportedMesh> result = importMesh(path);
    QVERIFY2(messageOf(result).contains(message), qPrintable(messageOf(result)));
    QVERIFY(QString::fromStdString(result.error().where).startsWith(path));
    QVERIFY(!result.error().advice.empty());
    QVERIFY(!messageOf(result).contains(QLatin1Char('\n')));
}

/// Some programs leave out what ends the file.
void BadInputTest::cutBetweenTriangles() {
    const QByteArray triangle =
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
        "endfacet\n";
    for (const auto& [bytes, notes] : {std::pair(triangle, 1), std::pair(triangle + "endsolid a\n", 0)}) {
        const auto read =
            importMesh(writeFile(m_folder.path(), QStringLiteral("a.stl"), bytes.toStdString()));
        QVERIFY2(read.ok(), read ? "" : read.error().message().c_str());
        QCOMPARE(read.value().notes.size(), notes);
    }
}

void BadInputTest::noFile_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("message");
    QVERIFY(QDir(m_folder.path()).mkpath(QStringLiteral("folder.obj")));
    QCOMPARE(::mkfifo(QFile::encodeName(m_folder.filePath(QStringLiteral("pipe.obj"))).constData(), 0600), 0);
    QVERIFY(QFile::link(QStringLiteral("nowhere"), m_folder.filePath(QStringLiteral("link.obj"))));
    QTest::newRow("missing") << m_folder.filePath(QStringLiteral("lost.obj")) << "There is no such file.";
    QTest::newRow("folder") << m_folder.filePath(QStringLiteral("folder.obj")) << "This is a folder";
    QTest::newRow("pipe") << m_folder.filePath(QStringLiteral("pipe.obj")) << "This is a pipe or a device";
    QTest::newRow("device") << "/dev/zero"
                            << "This is a pipe or a device";
    QTest::newRow("dangling link") << m_folder.filePath(QStringLiteral("link.obj"))
                                   << "a file that does not exist";
    QTest::newRow("nothing") << ""
                             << "There is no such file.";
}

void BadInputTest::noFile() {
    QFETCH(QString, name);
    QFETCH(QString, message);
    const Result<ImportedMesh> result = importMesh(name);
    QVERIFY2(messageOf(result).contains(message), qPrintable(messageOf(result)));
    QVERIFY(!result.error().advice.empty());
}

void BadInputTest::unreadable() {
    if (::geteuid() == 0) {
        QSKIP("The superuser may read every file.");
    }
    const QString path = writeFile(m_folder.path(), QStringLiteral("locked.obj"), "v 0 0 0\n");
    QVERIFY(QFile::setPermissions(path, {}));
    QVERIFY(messageOf(importMesh(path)).contains(QStringLiteral("You are not allowed to read this file.")));
}

void BadInputTest::trouble_data() {
    QTest::addColumn<QString>("obj");
    QTest::addColumn<QString>("note");
    QTest::newRow("missing library") << "mtllib lost.mtl\n"
                                     << "\"lost.mtl\" is not in the mesh's folder";
    QTest::newRow("library outside") << "mtllib /etc/passwd\n"
                                     << "\"/etc/passwd\" is not in the mesh's folder";
    QTest::newRow("library is a pipe") << "mtllib stuck.mtl\n"
                                       << "\"stuck.mtl\" is not in the mesh's folder";
    QTest::newRow("missing texture") << "mtllib tex.mtl\n"
                                     << "The texture \"lost.png\" is not shown";
    QTest::newRow("missing material") << "usemtl dust\n"
                                      << "No definition was found for the material dust";
}

void BadInputTest::trouble() {
    QFETCH(QString, obj);
    QFETCH(QString, note);
    ::mkfifo(QFile::encodeName(m_folder.filePath(QStringLiteral("stuck.mtl"))).constData(), 0600);
    writeFile(m_folder.path(), QStringLiteral("tex.mtl"), "newmtl a\nmap_Kd lost.png\n");
    const QString path = writeFile(m_folder.path(), QStringLiteral("trouble.obj"),
                                   obj.toStdString() + "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Result<ImportedMesh> result = importMesh(path);
    QVERIFY2(result.ok(), qPrintable(messageOf(result)));
    QCOMPARE(result.value().mesh.faceCount(), std::size_t(1));
    QCOMPARE(result.value().notes.size(), 1);
    QVERIFY2(result.value().notes[0].contains(note), qPrintable(result.value().notes[0]));
}

void BadInputTest::tooMuchMemory() {
#ifdef HITSCOPE_SANITIZED
    QSKIP("A sanitizer's own addresses count as memory, so the worker sets no limit.");
#endif
    std::string text = "v 0 0 0\nf";
    for (int i = 0; i < 12'000'000; ++i) {
        text += " 1";
    }
    ImportLimits limits;
    limits.memoryBytes = 60u << 20;
    const Result<ImportedMesh> result =
        importMesh(writeFile(m_folder.path(), QStringLiteral("fat.obj"), text), limits);
    QVERIFY2(messageOf(result).contains(QStringLiteral("needs more memory than it may have")),
             qPrintable(messageOf(result)));
}

HITSCOPE_TEST(BadInputTest, QCoreApplication)

}  // namespace hitscope::io_bad_input_test

#include "io_bad_input_test.moc"
