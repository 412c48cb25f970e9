// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "io/readers/mtl_reader.h"
#include "io/readers/obj_reader.h"
#include "io/readers/textures.h"
#include "io_support.h"
#include "support/test_program.h"

using namespace hitscope;
using namespace hitscope::test;

namespace {

constexpr const char* kObj =
    "mtllib %1\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl wood\nf 1 2 3\nusemtl tin\nf 3 2 1\n";

}  // namespace

class MaterialsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init();
    void parsesMtl();
    void keepsDefaultsForWhatIsMissing();
    void fillsInTheMaterialsOfAnObj();
    void findsLibraries_data();
    void findsLibraries();
    void notesMissingLibraryAndMaterials();
    void decodesTextures();
    void keepsToTheFolder_data();
    void keepsToTheFolder();
    void notesBrokenPictures();

private:
    ImportedMesh read(const QString& library);

    std::unique_ptr<QTemporaryDir> m_outer;  ///< of the folder that the mesh is in
    QString m_folder;
};

void MaterialsTest::init() {
    m_outer = std::make_unique<QTemporaryDir>();
    m_folder = m_outer->filePath(QStringLiteral("mesh"));
    QVERIFY(QDir().mkpath(m_folder));
}

ImportedMesh MaterialsTest::read(const QString& library) {
    ImportedMesh imported = parseObj(QString::fromLatin1(kObj).arg(library).toStdString()).value();
    readMaterialLibraries(imported, m_folder);
    readTextures(imported, m_folder);
    return imported;
}

void MaterialsTest::parsesMtl() {
    const std::vector<Material> materials = parseMtl(
        "# comment\r\nnewmtl dark wood\r\nKa 0.25 0.5 0.75\r\nKd 1 0 0.5\r\nKs 0 1 0\r\nNs 250\r\nd 0.5\r\n"
        "map_Kd -s 2 2 2 a wood.png\r\n\r\nnewmtl glass\r\nTr 0.75\r\nKd 2 -1 nan\r\n");
    QCOMPARE(materials.size(), std::size_t(2));
    QCOMPARE(materials[0].name, std::string("dark wood"));
    QCOMPARE(materials[0].ambient, glm::vec3(0.25f, 0.5f, 0.75f));
    QCOMPARE(materials[0].diffuse, glm::vec3(1, 0, 0.5f));
    QCOMPARE(materials[0].specular, glm::vec3(0, 1, 0));
    QCOMPARE(materials[0].shininess, 250.0f);
    QCOMPARE(materials[0].opacity, 0.5f);
    QCOMPARE(materials[0].diffuseTexture, std::string("a wood.png"));
    QCOMPARE(materials[1].opacity, 0.25f);
    QCOMPARE(materials[1].diffuse.x, 1.0f);  // into [0, 1]
    QCOMPARE(materials[1].diffuse.y, 0.0f);
}

void MaterialsTest::keepsDefaultsForWhatIsMissing() {
    const std::vector<Material> materials = parseMtl("newmtl a\nKd 0 0 0\nnewmtl b\nKs 1 1 1\n");
    QCOMPARE(materials.at(0).diffuse, glm::vec3(0));
    QCOMPARE(materials.at(0).specular, Material().specular);
    QCOMPARE(materials.at(1).diffuse, Material().diffuse);
    QCOMPARE(materials.at(1).specular, glm::vec3(1));
    QVERIFY(parseMtl("Kd 1 1 1\n").empty());
    QVERIFY(parseMtl(std::string("\0\xff\x89PNG", 6)).empty());
}

void MaterialsTest::fillsInTheMaterialsOfAnObj() {
    writeFile(m_folder, QStringLiteral("a.mtl"),
              "newmtl unused\nKd 0 0 1\nnewmtl tin\nKd 0 1 0\nnewmtl wood\nKd 1 0 0\n");
    const ImportedMesh imported = read(QStringLiteral("a.mtl"));
    QCOMPARE(imported.notes, QStringList());
    const std::vector<Material>& materials = imported.mesh.materials;
    QCOMPARE(materials.size(), std::size_t(3));
    QCOMPARE(materials[0].name, std::string("wood"));
    QCOMPARE(materials[0].diffuse, glm::vec3(1, 0, 0));
    QCOMPARE(materials[1].diffuse, glm::vec3(0, 1, 0));
    QCOMPARE(materials[2].name, std::string("unused"));
}

void MaterialsTest::findsLibraries_data() {
    QTest::addColumn<QString>("line");
    QTest::newRow("two on a line") << "wood.mtl tin.mtl";
    QTest::newRow("a blank in the name") << "wood and tin.mtl";
    QTest::newRow("from Windows") << "lib\\both.mtl";
}

void MaterialsTest::findsLibraries() {
    QFETCH(QString, line);
    QVERIFY(QDir(m_folder).mkpath(QStringLiteral("lib")));
    writeFile(m_folder, QStringLiteral("wood.mtl"), "newmtl wood\nKd 1 0 0\n");
    writeFile(m_folder, QStringLiteral("tin.mtl"), "newmtl tin\nKd 0 1 0\n");
    writeFile(m_folder, QStringLiteral("wood and tin.mtl"), "newmtl wood\nKd 1 0 0\nnewmtl tin\nKd 0 1 0\n");
    writeFile(m_folder, QStringLiteral("lib/both.mtl"), "newmtl wood\nKd 1 0 0\nnewmtl tin\nKd 0 1 0\n");
    const ImportedMesh imported = read(line);
    QCOMPARE(imported.notes, QStringList());
    QCOMPARE(imported.mesh.materials.at(0).diffuse, glm::vec3(1, 0, 0));
    QCOMPARE(imported.mesh.materials.at(1).diffuse, glm::vec3(0, 1, 0));
}

void MaterialsTest::notesMissingLibraryAndMaterials() {
    const ImportedMesh imported = read(QStringLiteral("lost.mtl"));
    QCOMPARE(imported.notes.size(), 2);
    QVERIFY(imported.notes[0].contains(QStringLiteral("\"lost.mtl\" is not in the mesh's folder")));
    QVERIFY(imported.notes[1].contains(QStringLiteral("materials wood, tin")));
    QCOMPARE(imported.mesh.faceCount(), std::size_t(2));
    // Not outside the folder either, where there is one.
    writeFile(m_outer->path(), QStringLiteral("lost.mtl"), "newmtl wood\nKd 1 0 0\n");
    QCOMPARE(read(QStringLiteral("../lost.mtl")).notes.size(), 2);
}

void MaterialsTest::decodesTextures() {
    QVERIFY(QDir(m_folder).mkpath(QStringLiteral("maps")));
    writeFile(m_folder, QStringLiteral("maps/w.png"), smallPng().toStdString());
    writeFile(m_folder, QStringLiteral("a.mtl"),
              "newmtl wood\nmap_Kd maps\\w.png\nnewmtl tin\nmap_Kd maps\\w.png\n");
    const ImportedMesh imported = read(QStringLiteral("a.mtl"));
    QCOMPARE(imported.notes, QStringList());
    QCOMPARE(imported.mesh.images.size(), std::size_t(1));  // once, however many materials have it
    QCOMPARE(imported.mesh.materials[0].diffuseImage, 0);
    QCOMPARE(imported.mesh.materials[1].diffuseImage, 0);
    QCOMPARE(imported.mesh.images[0].width, 2);
    QCOMPARE(imported.mesh.images[0].pixels, (std::vector<std::uint8_t>{255, 0, 0, 255, 0, 255, 0, 128}));
    QVERIFY(validate(imported.mesh).ok());
}

void MaterialsTest::keepsToTheFolder_data() {
    QTest::addColumn<QString>("texture");
    QTest::newRow("dots") << "../secret.png";
    QTest::newRow("dots inside") << "maps/../../secret.png";
    QTest::newRow("absolute") << "/OUTER/secret.png";
    QTest::newRow("link") << "link.png";
    QTest::newRow("folder") << "maps";
}

void MaterialsTest::keepsToTheFolder() {
    QFETCH(QString, texture);
    QVERIFY(QDir(m_folder).mkpath(QStringLiteral("maps")));
    const QString secret = writeFile(m_outer->path(), QStringLiteral("secret.png"), smallPng().toStdString());
    QVERIFY(QFile::link(secret, m_folder + QStringLiteral("/link.png")));
    texture.replace(QStringLiteral("/OUTER"), m_outer->path());
    writeFile(m_folder, QStringLiteral("a.mtl"),
              "newmtl wood\nmap_Kd " + texture.toStdString() + "\nnewmtl tin\nKd 0 0 0\n");
    const ImportedMesh imported = read(QStringLiteral("a.mtl"));
    QVERIFY(imported.mesh.images.empty());
    QCOMPARE(imported.mesh.materials[0].diffuseImage, -1);
    QCOMPARE(imported.notes.size(), 1);
    QVERIFY2(imported.notes[0].contains(QStringLiteral("is not in the mesh's folder")),
             qPrintable(imported.notes[0]));
}

void MaterialsTest::notesBrokenPictures() {
    const std::string png = smallPng().toStdString();
    writeFile(m_folder, QStringLiteral("cut.png"), png.substr(0, png.size() / 2));
    writeFile(m_folder, QStringLiteral("text.png"), "no picture");
    writeFile(m_folder, QStringLiteral("a.mtl"),
              "newmtl wood\nmap_Kd cut.png\nnewmtl tin\nmap_Kd text.png\n");
    const ImportedMesh imported = read(QStringLiteral("a.mtl"));
    QCOMPARE(imported.notes.size(), 2);
    QVERIFY(imported.notes[1].contains(QStringLiteral("it is not a picture of a known format")));
    QVERIFY(imported.mesh.images.empty());
    for (const char* const huge : {"P6 9000 1 255\n", "P6 1 9000 255\n"}) {
        QString why;
        QVERIFY(!decodeImage(huge, why));
        QVERIFY2(why.contains(QStringLiteral("larger than 8192 x 8192")), qPrintable(why));
    }
}

HITSCOPE_TEST(MaterialsTest, QCoreApplication)
#include "io_materials_test.moc"
