// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFile>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

#include "io/read_picture.h"
#include "io/readers/mtl_reader.h"
#include "io/readers/obj_reader.h"
#include "io/readers/textures.h"
#include "io_support.h"
#include "support/test_program.h"

namespace hitscope::io_materials_test {

using namespace test;

namespace {

constexpr const char* kObj =
    "mtllib %1\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl wood\nf 1 2 3\nusemtl tin\nf 3 2 1\n";

}  // namespace

class MaterialsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init();
    void parsesMtl();
    void findsNamesBehindOptions_data();
    void findsNamesBehindOptions();
    void keepsDefaultsForWhatIsMissing();
    void fillsInTheMaterialsOfAnObj();
    void findsLibraries_data();
    void findsLibraries();
    void takesNamesOfAnyBytes_data();
    void takesNamesOfAnyBytes();
    void notesMissingLibraryAndMaterials();
    void decodesTextures();
    void readsNormalMaps();
    void readsMetalnessAndRoughness_data();
    void readsMetalnessAndRoughness();
    void readsMapsOfMetalnessAndRoughness();
    void keepsToTheFolder_data();
    void keepsToTheFolder();
    void readsTga_data();
    void readsTga();
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

void MaterialsTest::findsNamesBehindOptions_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<QByteArray>("name");
    const auto row = [](const char* line, const char* name = "x.png") {
        QTest::newRow(line) << QByteArray(line) << QByteArray(name);
    };
    row("map_Kd x.png");
    row("map_Kd -s 2 2 2 x.png");
    row("map_Kd -s 2 2 x.png");
    row("map_Kd -o 0.5 x.png");
    row("map_Kd -t .1 1e-1 x.png");
    row("map_Kd -s 0,5 0,5 0,5 x.png");
    row("map_Kd -mm 0 1 x.png");
    row("map_Kd\t-s\t2\t2\tx.png \t");
    row("map_Kd -s 2 2 2 -o 0 0 -bm 1 t x.png", "t x.png");
    row("map_Kd -clamp on -cc off -blendu off -imfchan r -texres 512 -s 2 x.png");
    row("map_Kd -s 2 2 my -o 3 x.png", "my -o 3 x.png");
    row("map_Kd -spot.png", "-spot.png");
    row("map_Kd -s 1 1 2nd wood.png", "2nd wood.png");
    row("map_Kd -s 1 1", "");
}

void MaterialsTest::findsNamesBehindOptions() {
    QFETCH(QByteArray, line);
    const std::string text = "newmtl a\n" + line.toStdString() + "\r\n";
    QTEST(QByteArray::fromStdString(parseMtl(text).at(0).diffuseTexture), "name");
    const std::string bump = "newmtl a\nbump -s 2 2 -bm 0.5 -o 1 x.png\nmap_Ks -s 2 shine.png\n";
    QStringList others;
    const NormalMap map = parseMtl(bump, &others).at(0).normalMap;
    QCOMPARE(map.texture, std::string("x.png"));
    QCOMPARE(map.strength, 0.5f);
    QCOMPARE(others, (QStringList{QStringLiteral("shine.png"), QStringLiteral("x.png")}));
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

void MaterialsTest::takesNamesOfAnyBytes_data() {
    QTest::addColumn<QByteArray>("name");
    QTest::newRow("UTF-8") << QByteArray(
        "M\xc3\xb6"
        "bel");
    QTest::newRow("Latin-1") << QByteArray(
        "M\xf6"
        "bel");
}

/// Of files, from programs that wrote them as their system did; those of materials may be no text at all.
void MaterialsTest::takesNamesOfAnyBytes() {
    QFETCH(QByteArray, name);
    const std::string file = name.toStdString();
    writeFile(m_folder, QStringLiteral("Möbel.mtl"), "newmtl w\x80\xff\nKd 1 0 0\nmap_Kd " + file + ".png\n");
    writeFile(m_folder, QStringLiteral("Möbel.png"), smallPng().toStdString());
    ImportedMesh imported = parseObj("mtllib " + file +
                                     ".mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl w\x80\xff\nf 1/1 2/1 "
                                     "3/1\n")
                                .value();
    readMaterialLibraries(imported, m_folder);
    readTextures(imported, m_folder);
    QCOMPARE(imported.notes, QStringList());
    QCOMPARE(imported.mesh.materials.size(), std::size_t{1});
    QCOMPARE(imported.mesh.materials[0].diffuse, glm::vec3(1, 0, 0));
    QVERIFY(imported.mesh.materials[0].diffuseImage >= 0);
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

void MaterialsTest::readsNormalMaps() {
    const std::vector<Material> materials = parseMtl(
        "newmtl a\nmap_Bump -bm 0.5 my bumps.png\nnewmtl b\nbump old.png\n"
        "newmtl c\nbump heights.png\nnorm normals.png\nnewmtl d\nKd 1 1 1\n");
    QCOMPARE(materials[0].normalMap.texture, std::string("my bumps.png"));
    QCOMPARE(materials[0].normalMap.strength, 0.5f);
    QVERIFY(materials[0].normalMap.kind == NormalMap::Kind::Bump);
    QCOMPARE(materials[1].normalMap.texture, std::string("old.png"));
    QCOMPARE(materials[2].normalMap.texture, std::string("normals.png"));
    QVERIFY(materials[2].normalMap.kind == NormalMap::Kind::Normals);
    QVERIFY(materials[3].normalMap.texture.empty());

    writeFile(m_folder, QStringLiteral("w.png"), smallPng().toStdString());
    QImage heights(2, 2, QImage::Format_RGB32);
    heights.fill(QColor(90, 90, 90));
    QVERIFY(heights.save(m_folder + QStringLiteral("/grey.png")));
    const auto readWith = [this](const std::string& statements) {
        writeFile(m_folder, QStringLiteral("a.mtl"), "newmtl wood\n" + statements + "newmtl tin\nKd 0 0 0\n");
        return read(QStringLiteral("a.mtl"));
    };
    const ImportedMesh good = readWith("map_Kd w.png\nnorm w.png\n");
    QCOMPARE(good.notes, QStringList());
    QCOMPARE(good.mesh.images.size(), std::size_t(1));
    QCOMPARE(good.mesh.materials[0].normalMap.image, 0);
    QVERIFY(validate(good.mesh).ok());
    const ImportedMesh missing = readWith("norm gone.png\n");
    QCOMPARE(missing.mesh.materials[0].normalMap.image, -1);
    QCOMPARE(missing.notes,
             QStringList{QStringLiteral(
                 "The normal map \"gone.png\" is not shown: it is not in the mesh's folder.")});
    const ImportedMesh grey = readWith("map_Bump grey.png\n");
    QCOMPARE(grey.mesh.materials[0].normalMap.image, -1);
    QCOMPARE(grey.notes.size(), 1);
    QVERIFY2(grey.notes[0].contains(QStringLiteral("heights")), qPrintable(grey.notes[0]));
}

void MaterialsTest::readsMetalnessAndRoughness_data() {
    QTest::addColumn<QByteArray>("lines");
    QTest::addColumn<float>("metalness");
    QTest::addColumn<float>("roughness");
    QTest::addColumn<QByteArray>("texture");
    const auto row = [](const char* name, const char* lines, float metalness, float roughness,
                        const char* texture = "") {
        QTest::newRow(name) << QByteArray(lines) << metalness << roughness << QByteArray(texture);
    };
    row("none", "Kd 1 1 1\nNs 90\n", 0.0f, -1.0f);
    row("both", "Pm 0.75\nPr 0.25\n", 0.75f, 0.25f);
    row("roughness alone", "Pr 0\n", 0.0f, 0.0f);
    row("metalness alone", "Pm 1\n", 1.0f, 0.5f);
    row("out of range", "Pr 3\nPm -1\n", 0.0f, 1.0f);
    row("one map", "map_Pr a b.png\nmap_Pm a b.png\n", 1.0f, 1.0f, "a b.png");
    row("one map and factors", "Pr 0.5\nPm 0.25\nmap_Pr m.png\nmap_Pm m.png\n", 0.25f, 0.5f, "m.png");
    row("map of roughness", "map_Pr m.png\n", 0.0f, 1.0f, "m.png");
    row("its blue would count", "Pm 0.5\nmap_Pr m.png\n", 0.5f, 0.5f);
    row("map of metalness", "map_Pm m.png\n", 0.0f, 0.5f);
    row("two maps", "map_Pr r.png\nmap_Pm m.png\n", 0.0f, 0.5f);
}

void MaterialsTest::readsMetalnessAndRoughness() {
    QFETCH(QByteArray, lines);
    const MetalRoughness metal = parseMtl("newmtl a\n" + lines.toStdString()).at(0).metalRoughness;
    QTEST(metal.metalness, "metalness");
    QTEST(metal.roughness, "roughness");
    QTEST(QByteArray::fromStdString(metal.texture), "texture");
    QCOMPARE(metal.isGiven(), lines.contains('P'));
}

void MaterialsTest::readsMapsOfMetalnessAndRoughness() {
    writeFile(m_folder, QStringLiteral("w.png"), smallPng().toStdString());
    writeFile(m_folder, QStringLiteral("a.mtl"),
              "newmtl wood\nmap_Pr w.png\nmap_Pm w.png\nnewmtl tin\nmap_Pr gone.png\nPr 0.5\n");
    const ImportedMesh imported = read(QStringLiteral("a.mtl"));
    QCOMPARE(imported.mesh.materials[0].metalRoughness.image, 0);
    QCOMPARE(imported.mesh.materials[1].metalRoughness.image, -1);
    QCOMPARE(imported.mesh.images.size(), std::size_t(1));
    QCOMPARE(imported.notes,
             QStringList{QStringLiteral("The map of metalness and roughness \"gone.png\" is not "
                                        "shown: it is not in the mesh's folder.")});
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

void MaterialsTest::readsTga_data() {
    QTest::addColumn<QByteArray>("tga");
    // 3 x 1 pixels: blue, red, red.
    const QByteArray size = QByteArray::fromHex("0300010018");
    QTest::newRow("one by one") << QByteArray::fromHex("000002000000000000000000") + size +
                                       QByteArray::fromHex("00ff00000000ff0000ff");
    QTest::newRow("run lengths") << QByteArray::fromHex("00000a000000000000000000") + size +
                                        QByteArray::fromHex("0000ff0000810000ff");
}

/// The format has no mark that tells it, and games are full of it.
void MaterialsTest::readsTga() {
    QFETCH(QByteArray, tga);
    writeFile(m_folder, QStringLiteral("skin.tga"), tga.toStdString());
    writeFile(m_folder, QStringLiteral("a.mtl"), "newmtl wood\nmap_Kd skin.tga\nnewmtl tin\n");
    const ImportedMesh imported = read(QStringLiteral("a.mtl"));
    QVERIFY2(imported.notes.isEmpty(), qPrintable(imported.notes.join(u' ')));
    QCOMPARE(imported.mesh.images.size(), std::size_t{1});
    const Image& image = imported.mesh.images[0];
    QCOMPARE(image.width, 3);
    const std::vector<unsigned char> pixels(image.pixels.begin(), image.pixels.end());
    QVERIFY((pixels == std::vector<unsigned char>{0, 0, 255, 255, 255, 0, 0, 255, 255, 0, 0, 255}));
    const Result<Image> chosen = readPicture(m_folder + QStringLiteral("/skin.tga"));
    QVERIFY(chosen.ok());
    QVERIFY(chosen.value().pixels == image.pixels);
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

}  // namespace hitscope::io_materials_test

#include "io_materials_test.moc"
