// SPDX-License-Identifier: GPL-3.0-or-later
// What an export puts beside its OBJ, and that nothing is lost by it.
#include <sys/wait.h>
#include <unistd.h>

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <csignal>

#include "export_support.h"
#include "io/export_obj.h"
#include "io/readers/obj_reader.h"
#include "io/staged_files.h"
#include "support/test_program.h"

namespace hitscope::io_export_files_test {

using namespace test;

class ExportFilesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init();
    void copiesTextures();
    void copiesNothingButPictures();
    void keepsModesAndOtherMaps();
    void isWholeWheneverItIsKilled_data();
    void isWholeWheneverItIsKilled();
    void keepsNormalMaps();
    void keepsMetalnessAndRoughness();
    void overwritesNothingElse();
    void renamesThatPictureAlone();
    void placesALibraryOnce();
    void leavesTexturesOfTheOwnFolderAlone();
    void writesEmbeddedPictures();
    void letsGoOfLargeReplacedFiles();
    void writesWhereLinksLead();
    void saysWhyItCannotWrite_data();
    void saysWhyItCannotWrite();

private:
    [[nodiscard]] QString in(const char* name) const { return m_folder->filePath(QString::fromLatin1(name)); }
    [[nodiscard]] QStringList filesIn(const char* folder) const;

    std::unique_ptr<QTemporaryDir> m_folder;
};

void ExportFilesTest::init() {
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("source/maps")));
    QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("target")));
}

/// Of all kinds, hidden ones too; sorted.
QStringList ExportFilesTest::filesIn(const char* folder) const {
    QStringList names;
    QDirIterator files(in(folder), QDir::Files | QDir::Hidden | QDir::System, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        names << QDir(in(folder)).relativeFilePath(files.next());
    }
    names.sort();
    return names;
}

void ExportFilesTest::copiesTextures() {
    const ImportedMesh original = read(writeRich(in("source")));
    ObjExport what = exportOf(original.mesh, original.mesh.positions);
    what.sourceFolder = in("source");
    QVERIFY(exportObj(what, in("target/a.obj")).ok());
    QCOMPARE(readFile(in("target/maps/wood.png")), smallPng().toStdString());
    QCOMPARE(readFile(in("target/rich.mtl")), std::string(kRichMtl));
    const ImportedMesh again = read(in("target/a.obj"));
    QCOMPARE(again.mesh.materialLibraries, std::vector<std::string>{"rich.mtl"});
    QCOMPARE(again.mesh.materials[0].diffuseTexture, std::string("maps/wood.png"));
    QCOMPARE(again.mesh.images.size(), std::size_t(1));
    QCOMPARE(again.mesh.materials[2].diffuseTexture, std::string("lost.png"));  // a name is better than none
}

/// A mesh file may name any file of the person's that lies below it.
void ExportFilesTest::copiesNothingButPictures() {
    QVERIFY(QDir(in("source")).mkdir(QStringLiteral(".ssh")));
    writeFile(in("source"), QStringLiteral(".ssh/id_rsa"), "-----BEGIN OPENSSH PRIVATE KEY-----\n");
    writeFile(in("source"), QStringLiteral("notes.mtl"), "my password is 1234\n");
    QFile sparse(writeFile(in("source"), QStringLiteral("huge.png"), smallPng().toStdString()));
    QVERIFY(sparse.resize(3ll << 30));
    QVERIFY(QFile::link(QStringLiteral("/etc/passwd"), in("source/linked.png")));
    // It begins as a picture does, and is none.
    writeFile(in("source"), QStringLiteral("half.png"),
              smallPng().first(33).toStdString() + "my password is 1234\n");
    writeFile(in("source"), QStringLiteral("evil.mtl"),
              "newmtl a\nmap_Kd .ssh/id_rsa\nnewmtl b\nmap_Kd huge.png\nmap_Ks .ssh/id_rsa\nmap_Ns half.png\n"
              "newmtl c\nmap_Kd linked.png\nmap_Ke huge.png\ndisp notes.mtl\nbump .ssh/id_rsa\n");
    const QString path = writeFile(in("source"), QStringLiteral("evil.obj"),
                                   "mtllib evil.mtl\nmtllib notes.mtl\nmtllib .ssh/id_rsa\n"
                                   "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
    const ImportedMesh original = read(path);
    QVERIFY(original.mesh.pictureFiles.empty());
    ObjExport what = exportOf(original.mesh, original.mesh.positions);
    what.sourceFolder = in("source");
    QVERIFY(exportObj(what, in("target/a.obj")).ok());
    QCOMPARE(filesIn("target"), (QStringList{QStringLiteral("a.obj"), QStringLiteral("evil.mtl")}));
    QCOMPARE(readFile(in("target/evil.mtl")), readFile(in("source/evil.mtl")));
    // Of a picture that has grown since, no more than the importer would read is read.
    const ImportedMesh rich = read(writeRich(in("source")));
    what = exportOf(rich.mesh, rich.mesh.positions);
    what.sourceFolder = in("source");
    QFile grown(in("source/maps/wood.png"));
    QVERIFY(grown.resize(3ll << 30));
    const Result<QStringList> written = exportObj(what, in("target/b.obj"));
    QVERIFY(!written);
    QVERIFY2(messageOf(written).contains(QStringLiteral("wood.png")), qPrintable(messageOf(written)));
    QCOMPARE(filesIn("target").size(), 2);
}

void ExportFilesTest::keepsModesAndOtherMaps() {
    const QByteArray bytes = smallPng();
    for (const char* const name : {"colour.png", "shine.png", "glow.png"}) {
        writeFile(in("source"), QString::fromLatin1(name), bytes.toStdString());
    }
    const QFile::Permissions own = QFile::ReadOwner | QFile::WriteOwner;
    QVERIFY(QFile::setPermissions(in("source/colour.png"), own));
    writeFile(in("source"), QStringLiteral("m.mtl"),
              "# as it was\nnewmtl a\nNi 1.45\nKe 1 2 3\nillum 7\nmap_Kd -s 2 2 1 colour.png\n"
              "map_Ks shine.png\nmap_Ke glow.png\n");
    QVERIFY(QFile::setPermissions(in("source/m.mtl"), own));
    const QString path = writeFile(in("source"), QStringLiteral("m.obj"),
                                   "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
    const ImportedMesh original = read(path);
    ObjExport what = exportOf(original.mesh, original.mesh.positions);
    what.sourceFolder = in("source");
    QVERIFY(exportObj(what, in("target/m.obj")).ok());
    QCOMPARE(filesIn("target"),
             (QStringList{QStringLiteral("colour.png"), QStringLiteral("glow.png"), QStringLiteral("m.mtl"),
                          QStringLiteral("m.obj"), QStringLiteral("shine.png")}));
    QCOMPARE(readFile(in("target/m.mtl")), readFile(in("source/m.mtl")));
    const QFile::Permissions ofOthers = QFile::ReadGroup | QFile::ReadOther;
    QVERIFY(!(QFile::permissions(in("target/colour.png")) & ofOthers));
    QVERIFY(!(QFile::permissions(in("target/m.mtl")) & ofOthers));
    QCOMPARE(QFile::permissions(in("target/glow.png")), QFile::permissions(in("source/glow.png")));
    // Over the source itself: all but the OBJ is as it was.
    const std::string library = readFile(in("source/m.mtl"));
    const QStringList before = filesIn("source");
    QVERIFY(exportObj(what, path).ok());
    QCOMPARE(readFile(in("source/m.mtl")), library);
    QCOMPARE(filesIn("source"), before);
    QCOMPARE(read(path).mesh.materialLibraries, std::vector<std::string>{"m.mtl"});
}

void ExportFilesTest::isWholeWheneverItIsKilled_data() {
    QTest::addColumn<bool>("hasLibrary");
    QTest::newRow("library copied") << true;
    QTest::newRow("library written") << false;
}

/// An old export lies there; another process is killed before each step of a new one.
void ExportFilesTest::isWholeWheneverItIsKilled() {
    QFETCH(bool, hasLibrary);
    ImportedMesh original = read(writeRich(in("source")));
    if (!hasLibrary) {
        original.mesh.materialLibraries.clear();
    }
    ObjExport what = exportOf(original.mesh, original.mesh.positions);
    what.sourceFolder = in("source");
    QVERIFY(exportObj(what, in("target/a.obj")).ok());
    const std::string oldObj = readFile(in("target/a.obj"));
    original.mesh.materials[0].shininess = 77.0f;  // another library, and another mesh
    writeFile(in("source"), QStringLiteral("rich.mtl"), std::string(kRichMtl) + "# changed\n");
    PageVector<glm::vec3> moved = original.mesh.positions;
    moved[0].x += 1.0f;
    what.positions = moved;
    bool hasEnded = false;
    int old = 0;
    for (int steps = 0; !hasEnded && steps < 50; ++steps) {
        const pid_t child = ::fork();
        QVERIFY(child >= 0);
        if (child == 0) {
            what.beforeStep = [left = steps]() mutable {
                if (left-- == 0) {
                    ::raise(SIGKILL);
                }
            };
            ::_exit(exportObj(what, in("target/a.obj")).ok() ? 0 : 1);
        }
        int status = 0;
        QCOMPARE(::waitpid(child, &status, 0), child);
        hasEnded = WIFEXITED(status);
        QVERIFY(!hasEnded || WEXITSTATUS(status) == 0);
        const ImportedMesh found = read(in("target/a.obj"));
        const bool isOld = readFile(in("target/a.obj")) == oldObj;
        old += isOld ? 1 : 0;
        QCOMPARE(found.notes.filter(QStringLiteral("material file")), QStringList());
        QCOMPARE(found.mesh.positions[0].x, isOld ? original.mesh.positions[0].x : moved[0].x);
        const QString library = in("target/") + QString::fromStdString(found.mesh.materialLibraries.at(0));
        const QString text = QString::fromStdString(readFile(library));
        QCOMPARE(text.contains(QStringLiteral("# changed")) || text.contains(QStringLiteral("Ns 77")),
                 !isOld);
    }
    QVERIFY(hasEnded && old > 3);
}

void ExportFilesTest::keepsNormalMaps() {
    writeFile(in("source"), QStringLiteral("n.png"), smallPng().toStdString());
    writeFile(in("source"), QStringLiteral("n.mtl"),
              "newmtl a\nmap_Bump -bm 0.25 n.png\nnewmtl b\nnorm -bm 2 n.png\nnewmtl c\nnorm lost.png\n");
    const QString path =
        writeFile(in("source"), QStringLiteral("n.obj"),
                  "mtllib n.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\nusemtl b\nf 3 2 1\n"
                  "usemtl c\nf 2 3 1\n");
    const ImportedMesh original = read(path);
    QCOMPARE(original.mesh.materials[1].normalMap.strength, 2.0f);
    ObjExport what = exportOf(original.mesh, original.mesh.positions);
    what.sourceFolder = in("source");
    QVERIFY(exportObj(what, in("target/n.obj")).ok());
    QCOMPARE(readFile(in("target/n.png")), smallPng().toStdString());
    const ImportedMesh again = read(in("target/n.obj"));
    QCOMPARE(again.mesh.materials.size(), original.mesh.materials.size());
    for (std::size_t m = 0; m < again.mesh.materials.size(); ++m) {
        const NormalMap& before = original.mesh.materials[m].normalMap;
        const NormalMap& after = again.mesh.materials[m].normalMap;
        QVERIFY(after.kind == before.kind);
        QCOMPARE(after.texture, before.texture);
        QCOMPARE(after.strength, before.strength);
        QCOMPARE(after.image, before.image);
    }
}

void ExportFilesTest::keepsMetalnessAndRoughness() {
    MeshData mesh =
        parseObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\nusemtl b\nf 3 2 1\n").value().mesh;
    mesh.images = {Image{1, 1, {1, 2, 3, 255}}};
    mesh.materials[0].metalRoughness = {0.25f, 0.75f, {}, 0};
    QVERIFY(exportObj(exportOf(mesh, mesh.positions), in("target/a.obj")).ok());
    const MeshData again = read(in("target/a.obj")).mesh;
    const MetalRoughness& metal = again.materials[0].metalRoughness;
    QCOMPARE(metal.metalness, 0.25f);
    QCOMPARE(metal.roughness, 0.75f);
    QCOMPARE(metal.image, 0);
    QCOMPARE(again.images.at(0).pixels, mesh.images[0].pixels);
    QVERIFY(!again.materials[1].metalRoughness.isGiven());
}

void ExportFilesTest::overwritesNothingElse() {
    const ImportedMesh original = read(writeRich(in("source")));
    QVERIFY(QDir(in("target")).mkdir(QStringLiteral("maps")));
    writeFile(in("target"), QStringLiteral("maps/wood.png"), "another picture");
    writeFile(in("target"), QStringLiteral("rich.mtl"), "another library");
    ObjExport what = exportOf(original.mesh, original.mesh.positions);
    what.sourceFolder = in("source");
    QVERIFY(exportObj(what, in("target/a.obj")).ok());
    QCOMPARE(readFile(in("target/maps/wood.png")), std::string("another picture"));
    QCOMPARE(readFile(in("target/rich.mtl")), std::string("another library"));
    // The library is the source's but for the picture's name.
    QCOMPARE(QString::fromStdString(readFile(in("target/rich-1.mtl"))),
             QString::fromUtf8(kRichMtl).replace(QStringLiteral("maps/wood.png"),
                                                 QStringLiteral("maps/wood-1.png")));
    ImportedMesh again = read(in("target/a.obj"));
    QCOMPARE(again.mesh.materialLibraries, std::vector<std::string>{"rich-1.mtl"});
    QCOMPARE(again.mesh.materials[0].diffuseTexture, std::string("maps/wood-1.png"));
    QCOMPARE(again.mesh.images.size(), std::size_t(1));
    // The same again: the files are there already.
    QVERIFY(exportObj(what, in("target/b.obj")).ok());
    QCOMPARE(filesIn("target"),
             (QStringList{QStringLiteral("a.obj"), QStringLiteral("b.obj"), QStringLiteral("maps/wood-1.png"),
                          QStringLiteral("maps/wood.png"), QStringLiteral("rich-1.mtl"),
                          QStringLiteral("rich.mtl")}));
}

/// Not another one whose name ends in its name.
void ExportFilesTest::renamesThatPictureAlone() {
    for (const char* const name : {"x.png", "t x.png", "\xe4.png"}) {
        writeFile(in("source"), QString::fromLatin1(name), smallPng().toStdString());
    }
    writeFile(in("target"), QStringLiteral("ä.png"), "another picture");
    writeFile(in("target"), QStringLiteral("x.png"), "another picture");
    const std::string begin = "newmtl a\r\nmap_Kd -s 2 2 t x.png\r\nnewmtl b\r\nmap_Kd -o 0.5 ";
    const std::string middle = "\r\nmap_Ks -s 1 1 ";
    writeFile(in("source"), QStringLiteral("m.mtl"), begin + "x.png" + middle + "\xe4.png");
    const ImportedMesh original =
        read(writeFile(in("source"), QStringLiteral("m.obj"),
                       "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\nusemtl b\nf 3 2 1\n"));
    ObjExport what = exportOf(original.mesh, original.mesh.positions);
    what.sourceFolder = in("source");
    QVERIFY(exportObj(what, in("target/m.obj")).ok());
    QCOMPARE(readFile(in("target/m.mtl")), begin + "x-1.png" + middle + "ä-1.png");
    QCOMPARE(filesIn("target"),
             (QStringList{QStringLiteral("m.mtl"), QStringLiteral("m.obj"), QStringLiteral("t x.png"),
                          QStringLiteral("x-1.png"), QStringLiteral("x.png"), QStringLiteral("ä-1.png"),
                          QStringLiteral("ä.png")}));
}

void ExportFilesTest::placesALibraryOnce() {
    writeFile(in("source"), QStringLiteral("m.mtl"), "newmtl a\nKd 1 0 0\n");
    const std::string text =
        "mtllib m.mtl\no A\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\nmtllib m.mtl\no B\nf 3 2 1\n";
    const QString path = writeFile(in("source"), QStringLiteral("m.obj"), text);
    const ImportedMesh original = read(path);
    ObjExport what = exportOf(original.mesh, original.mesh.positions);
    what.sourceFolder = in("source");
    QVERIFY(exportObj(what, in("target/anew.obj")).ok());
    what.sourcePath = path;
    QVERIFY(exportObj(what, in("target/maps.obj")).ok());
    QCOMPARE(readFile(in("target/maps.obj")), text);
    QCOMPARE(filesIn("target"),
             (QStringList{QStringLiteral("anew.obj"), QStringLiteral("m.mtl"), QStringLiteral("maps.obj")}));
    QVERIFY(QFile::remove(in("target/m.mtl")));
    QVERIFY(exportObj(what, in("target/maps.obj")).ok());  // not there yet
    QCOMPARE(readFile(in("target/maps.obj")), text);
    QCOMPARE(read(in("target/anew.obj")).mesh.materialLibraries, std::vector<std::string>{"m.mtl"});
    // Of another content than the one that is there.
    writeFile(in("target"), QStringLiteral("m.mtl"), "another library");
    QVERIFY(exportObj(what, in("target/maps.obj")).ok());
    QCOMPARE(read(in("target/maps.obj")).mesh.materialLibraries,
             (std::vector<std::string>{"m-1.mtl", "m-1.mtl"}));
    QCOMPARE(filesIn("target").size(), 4);
}

void ExportFilesTest::leavesTexturesOfTheOwnFolderAlone() {
    const ImportedMesh original = read(writeRich(in("source")));
    ObjExport what = exportOf(original.mesh, original.mesh.positions);
    what.sourceFolder = in("source");
    QVERIFY(exportObj(what, in("source/b.obj")).ok());
    QCOMPARE(read(in("source/b.obj")).mesh.materials[0].diffuseTexture, std::string("maps/wood.png"));
    QCOMPARE(filesIn("source"), (QStringList{QStringLiteral("b.obj"), QStringLiteral("maps/wood.png"),
                                             QStringLiteral("rich.mtl"), QStringLiteral("rich.obj")}));
}

void ExportFilesTest::writesEmbeddedPictures() {
    MeshData mesh =
        parseObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\nusemtl b\nf 3 2 1\n").value().mesh;
    mesh.images = {Image{1, 1, {1, 2, 3, 255}}};
    mesh.materials[0].diffuseImage = 0;
    mesh.materials[1].diffuseImage = 0;
    QVERIFY(exportObj(exportOf(mesh, mesh.positions), in("target/a.obj")).ok());
    const ImportedMesh again = read(in("target/a.obj"));
    QCOMPARE(again.mesh.materials[1].diffuseTexture, std::string("a_texture1.png"));
    QCOMPARE(again.mesh.images.size(), std::size_t(1));
    QCOMPARE(again.mesh.images[0].pixels, mesh.images[0].pixels);
}

void ExportFilesTest::letsGoOfLargeReplacedFiles() {
    const auto isStillOpen = [](const QFileInfo& file) {
        return file.symLinkTarget().contains(QStringLiteral("target/large.obj"));
    };
    const auto openFiles = [&isStillOpen] {
        const QFileInfoList files =
            QDir(QStringLiteral("/proc/self/fd")).entryInfoList(QDir::AllEntries | QDir::System);
        return std::count_if(files.begin(), files.end(), isStillOpen);
    };
    const std::string old(20 << 20, 'o');
    QVERIFY(writeWhole(in("target/large.obj"), old));
    QVERIFY(writeWhole(in("target/large.obj"), "new"));
    QCOMPARE(QFileInfo(in("target/large.obj")).size(), qint64{3});
    QTRY_COMPARE(openFiles(), 0);
}

/// To a file, and to where there is none yet, over another link.
void ExportFilesTest::writesWhereLinksLead() {
    QVERIFY(QFile::link(QStringLiteral("second.obj"), in("target/first.obj")));
    QVERIFY(QFile::link(QStringLiteral("../source/it.obj"), in("target/second.obj")));
    for (const char* content : {"new", "newer"}) {
        QVERIFY(writeWhole(in("target/first.obj"), content));
        QCOMPARE(readFile(in("source/it.obj")), std::string(content));
        QVERIFY(QFileInfo(in("target/first.obj")).isSymLink());
        QVERIFY(QFileInfo(in("target/second.obj")).isSymLink());
    }
    QVERIFY(QFile::link(QStringLiteral("round.obj"), in("target/round.obj")));
    QVERIFY(!writeWhole(in("target/round.obj"), "new"));
}

void ExportFilesTest::saysWhyItCannotWrite_data() {
    QTest::addColumn<QString>("path");
    QTest::newRow("no such folder") << "nowhere/a.obj";
    QTest::newRow("is a folder") << "target";
    QTest::newRow("inside a device") << "/dev/full/a.obj";
}

void ExportFilesTest::saysWhyItCannotWrite() {
    QFETCH(QString, path);
    const MeshData mesh = parseObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").value().mesh;
    const Result<QStringList> written =
        exportObj(exportOf(mesh, mesh.positions), QDir(m_folder->path()).filePath(path));
    QVERIFY(!written);
    QVERIFY2(messageOf(written).contains(QStringLiteral("cannot be saved")), qPrintable(messageOf(written)));
    QVERIFY(!written.error().where.empty() && !written.error().advice.empty());
    const std::vector<glm::vec3> tooFew(2);
    QVERIFY(!exportObj(exportOf(mesh, tooFew), in("target/b.obj")));
    QVERIFY(!QFile::exists(in("target/b.obj")));
}

HITSCOPE_TEST(ExportFilesTest, QCoreApplication)

}  // namespace hitscope::io_export_files_test

#include "io_export_files_test.moc"
