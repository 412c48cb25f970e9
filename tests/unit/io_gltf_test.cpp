// SPDX-License-Identifier: GPL-3.0-or-later
// What glTF files hold beyond the plain ones of io_formats_test.
#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include "gltf_support.h"
#include "io/import.h"
#include "io_support.h"
#include "support/test_program.h"

namespace hitscope::io_gltf_test {

using namespace test;

namespace {

QString messageIn(const Result<ImportedMesh>& read) {
    return messageOf(read) + QLatin1Char(' ') +
           (read ? read.value().notes.join(QLatin1Char(' ')) : QString());
}

QJsonObject members(const char* json) {
    return QJsonDocument::fromJson(json).object();
}

/// Corners of small integers, then a normal and texture coordinates each, 16 bytes a corner.
std::string interleavedCorners() {
    std::string bytes;
    for (const auto& [x, y] : {std::pair{0, 0}, std::pair{32767, 0}, std::pair{-32768, 16384}}) {
        put(bytes, static_cast<std::int16_t>(x), static_cast<std::int16_t>(y), std::int16_t{-7},
            std::int16_t{0});
        put(bytes, std::int8_t{0}, std::int8_t{0}, std::int8_t{-127}, std::int8_t{0});
        put(bytes, static_cast<std::uint16_t>(x == 0 ? 0 : 65535), static_cast<std::uint16_t>(y));
    }
    return bytes;
}

GltfFile quantisedFile(bool isNormalised) {
    GltfFile file;
    const QJsonObject normalised{{QStringLiteral("normalized"), true}};
    const auto at = [&normalised](int offset) {
        QJsonObject members = normalised;
        members[QStringLiteral("byteOffset")] = offset;
        return members;
    };
    file.view(std::string(3, 'x'));
    const int view = file.view(interleavedCorners(), 16);
    file.attributes = {
        {QStringLiteral("POSITION"),
         file.accessor(view, kShort, "VEC3", 3, isNormalised ? normalised : QJsonObject())},
        {QStringLiteral("NORMAL"), file.accessor(view, kByte, "VEC3", 3, at(8))},
        {QStringLiteral("TEXCOORD_0"), file.accessor(view, kUnsignedShort, "VEC2", 3, at(12))}};
    file.more = members(R"({"extensionsUsed": ["KHR_mesh_quantization"],
                            "extensionsRequired": ["KHR_mesh_quantization"]})");
    return file;
}

}  // namespace

class GltfTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void encodedNames_data();
    void encodedNames();
    void encodedNamesStayInTheFolder();
    void encodedPictures();
    void quantised_data();
    void quantised();
    void quantisedMorphs();
    void quantisedAndCompressed();
    void smallTextureCoordinates_data();
    void smallTextureCoordinates();
    void sparseAndInterleaved();
    void wrongNumbers_data();
    void wrongNumbers();
    void extensions_data();
    void extensions();
    void scenes_data();
    void scenes();

private:
    QString write(const QString& name, const std::string& content) {
        return writeFile(m_folder.path(), name, content);
    }
    QTemporaryDir m_folder;
};

void GltfTest::encodedNames_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("uri");
    QTest::newRow("a blank") << "a b.bin"
                             << "a%20b.bin";
    QTest::newRow("beyond ASCII") << QStringLiteral("m\u00fchle.bin") << "m%C3%BChle.bin";
    QTest::newRow("not encoded") << "a b c.bin"
                                 << "a b c.bin";
    QTest::newRow("a percent sign") << "5%25.bin"
                                    << "5%25.bin";
    QTest::newRow("in a folder") << "in ner/a.bin"
                                 << "in%20ner/a.bin";
}

void GltfTest::encodedNames() {
    QFETCH(QString, file);
    QFETCH(QString, uri);
    QVERIFY(QDir(m_folder.path()).mkpath(QStringLiteral("in ner")));
    const GltfFile triangle = triangleFile();
    write(file, triangle.numbers);
    const Result<ImportedMesh> read = importMesh(write(QStringLiteral("a.gltf"), triangle.text(uri)));
    QVERIFY2(read.ok(), qPrintable(messageOf(read)));
    QCOMPARE(read.value().mesh.positions[1], glm::vec3(100, 0, 0));
}

/// The folder's own name is no URI.
void GltfTest::encodedNamesStayInTheFolder() {
    QVERIFY(QDir(m_folder.path()).mkpath(QStringLiteral("5%20in")));
    const GltfFile triangle = triangleFile();
    write(QStringLiteral("out.bin"), triangle.numbers);
    for (const char* const uri : {"%2e%2e/out.bin", "%2E%2E%2Fout.bin", "..%5cout.bin", "%2e./out.bin"}) {
        const Result<ImportedMesh> read =
            importMesh(write(QStringLiteral("5%20in/a.gltf"), triangle.text(QString::fromLatin1(uri))));
        QVERIFY2(!read.ok(), uri);
        QVERIFY2(messageOf(read).contains(QStringLiteral("could not open referenced file")),
                 qPrintable(messageOf(read)));
    }
    write(QStringLiteral("5%20in/a b.bin"), triangle.numbers);
    const QString path =
        write(QStringLiteral("5%20in/a.gltf"), triangle.text(QStringLiteral("./x%2F../a%20b.bin")));
    QVERIFY(QDir(m_folder.path()).mkpath(QStringLiteral("5%20in/x")));
    const Result<ImportedMesh> read = importMesh(path);
    QVERIFY2(read.ok(), qPrintable(messageOf(read)));
}

void GltfTest::encodedPictures() {
    write(QStringLiteral("my tex.png"), smallPng().toStdString());
    GltfFile file = triangleFile();
    file.primitive = {{QStringLiteral("material"), 0}};
    const QByteArray material = R"({"images": [{"uri": "my%20tex.png"}, {"uri": "gone%20too.png"}],
        "textures": [{"source": 0}, {"source": 1}],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0},
                       "metallicRoughnessTexture": {"index": 0}}, "normalTexture": {"index": 1}}]})";
    file.more = QJsonDocument::fromJson(material).object();
    const Result<ImportedMesh> read = importMesh(write(QStringLiteral("p.gltf"), file.text()));
    QVERIFY2(read.ok(), qPrintable(messageOf(read)));
    const Material& paint = read.value().mesh.materials.at(0);
    QCOMPARE(paint.diffuseTexture, std::string("my tex.png"));
    QCOMPARE(paint.diffuseImage, 0);
    QCOMPARE(paint.metalRoughness.image, 0);
    QCOMPARE(read.value().mesh.pictureFiles, std::vector<std::string>{"my tex.png"});
    QCOMPARE(paint.normalMap.texture, std::string("gone%20too.png"));
}

void GltfTest::quantised_data() {
    QTest::addColumn<bool>("isNormalised");
    QTest::addColumn<QString>("name");
    for (const bool isNormalised : {false, true}) {
        const char* const how = isNormalised ? "normalised" : "whole";
        for (const char* const name : {"q.gltf", "q.glb", "q beside.gltf"}) {
            QTest::addRow("%s, %s", how, name) << isNormalised << QString::fromLatin1(name);
        }
    }
}

void GltfTest::quantised() {
    QFETCH(bool, isNormalised);
    QFETCH(QString, name);
    const GltfFile file = quantisedFile(isNormalised);
    write(QStringLiteral("q 1.bin"), file.numbers);
    const QString uri = name.contains(QLatin1Char(' ')) ? QStringLiteral("q%201.bin") : QString();
    const QString path = write(name, name.endsWith(QLatin1String("glb")) ? file.glb() : file.text(uri));
    const Result<ImportedMesh> read = importMesh(path);
    QVERIFY2(read.ok(), qPrintable(messageOf(read)));
    const MeshData& mesh = read.value().mesh;
    const float all = isNormalised ? 32767.0f : 1.0f;
    QCOMPARE(mesh.positions[0], glm::vec3(0, 0, -7 / all));
    QCOMPARE(mesh.positions[1], glm::vec3(32767 / all, 0, -7 / all));
    QCOMPARE(mesh.positions[2], glm::vec3(isNormalised ? -1 : -32768, 16384 / all, -7 / all));
    QCOMPARE(mesh.normals.at(2), glm::vec3(0, 0, -1));
    QCOMPARE(mesh.texcoords.at(1), glm::vec2(1, 1));
    QCOMPARE(mesh.texcoords.at(2), glm::vec2(1, 1 - 16384 / 65535.0f));
    QCOMPARE(read.value().notes, QStringList());
}

void GltfTest::quantisedMorphs() {
    GltfFile file = triangleFile();
    std::string moves;
    put(moves, std::int8_t{1}, std::int8_t{2}, std::int8_t{-3}, std::int8_t{0}, std::int8_t{0},
        std::int8_t{0}, std::int8_t{0}, std::int8_t{0}, std::int8_t{0}, std::int8_t{0}, std::int8_t{5},
        std::int8_t{0});
    const int target = file.accessor(file.view(moves, 4), kByte, "VEC3", 3);
    const QJsonObject triangle{
        {QStringLiteral("attributes"), file.attributes},
        {QStringLiteral("targets"), QJsonArray{QJsonObject{{QStringLiteral("POSITION"), target}}}}};
    const QJsonObject mesh{{QStringLiteral("primitives"), QJsonArray{triangle}},
                           {QStringLiteral("weights"), QJsonArray{1}}};
    file.more[QStringLiteral("meshes")] = QJsonArray{mesh};
    const Result<ImportedMesh> read = importMesh(write(QStringLiteral("m.gltf"), file.text()));
    QVERIFY2(read.ok(), qPrintable(messageOf(read)));
    QCOMPARE(read.value().mesh.positions, (PageVector<glm::vec3>{{1, 2, -3}, {100, 0, 0}, {0, 100, 5}}));
}

void GltfTest::quantisedAndCompressed() {
    GltfFile file = quantisedFile(false);
    file.primitive = members(R"({"extensions": {"KHR_draco_mesh_compression": {"bufferView": 0}}})");
    QJsonObject position = file.accessors[0].toObject();
    position.remove(QStringLiteral("bufferView"));
    file.accessors[0] = position;
    const QString message = messageOf(importMesh(write(QStringLiteral("d.gltf"), file.text())));
    QVERIFY2(message.contains(QStringLiteral("its POSITION is quantised")), qPrintable(message));
    QVERIFY2(message.contains(QStringLiteral("Export it without quantisation")), qPrintable(message));
}

void GltfTest::smallTextureCoordinates_data() {
    QTest::addColumn<int>("type");
    QTest::newRow("bytes") << kUnsignedByte;
    QTest::newRow("shorts") << kUnsignedShort;
}

/// What glTF 2.0 allows without an extension.
void GltfTest::smallTextureCoordinates() {
    QFETCH(int, type);
    std::string bytes;
    for (const int part : {0, 255, 255, 0, 51, 102}) {
        if (type == kUnsignedByte) {
            put(bytes, static_cast<std::uint8_t>(part));
            bytes.append(bytes.size() % 4 == 2 ? 2 : 0, 0);  // four bytes each
        } else {
            put(bytes, static_cast<std::uint16_t>(257 * part));
        }
    }
    GltfFile file = triangleFile();
    file.attributes[QStringLiteral("TEXCOORD_0")] =
        file.accessor(file.view(bytes, 4), type, "VEC2", 3, {{QStringLiteral("normalized"), true}});
    const Result<ImportedMesh> read = importMesh(write(QStringLiteral("t.gltf"), file.text()));
    QVERIFY2(read.ok(), qPrintable(messageOf(read)));
    const MeshData& mesh = read.value().mesh;
    QCOMPARE(mesh.positions[1], glm::vec3(100, 0, 0));
    QCOMPARE(mesh.texcoords.at(0), glm::vec2(0, 0));
    QCOMPARE(mesh.texcoords.at(1), glm::vec2(1, 1));
    QCOMPARE(mesh.texcoords.at(2), glm::vec2(0.2f, 1 - 0.4f));
}

void GltfTest::sparseAndInterleaved() {
    GltfFile file;
    std::string corners;
    for (const float x : {0.0f, 100.0f, 50.0f}) {
        put(corners, x, 0.0f, 5.0f, 0.5f, 0.5f, 0.5f);
    }
    const int view = file.view(corners, 24);
    std::string places;
    put(places, std::uint16_t{2});
    std::string values;
    put(values, 0.0f, 1.0f, 0.25f);
    const QJsonObject sparse{
        {QStringLiteral("count"), 1},
        {QStringLiteral("indices"), QJsonObject{{QStringLiteral("bufferView"), file.view(places)},
                                                {QStringLiteral("componentType"), kUnsignedShort}}},
        {QStringLiteral("values"), QJsonObject{{QStringLiteral("bufferView"), file.view(values)}}}};
    for (const auto& [name, offset] : {std::pair{"POSITION", 0}, std::pair{"COLOR_0", 12}}) {
        file.attributes[QLatin1String(name)] =
            file.accessor(view, kFloatNumbers, "VEC3", 3,
                          {{QStringLiteral("byteOffset"), offset}, {QStringLiteral("sparse"), sparse}});
    }
    const Result<ImportedMesh> read = importMesh(write(QStringLiteral("s.gltf"), file.text()));
    QVERIFY2(read.ok(), qPrintable(messageOf(read)));
    const MeshData& mesh = read.value().mesh;
    QCOMPARE(mesh.positions, (PageVector<glm::vec3>{{0, 0, 5}, {100, 0, 5}, {0, 1, 0.25f}}));
    QCOMPARE(mesh.colours.at(0).x, mesh.colours.at(1).z);
    QVERIFY(mesh.colours.at(0).x > 0.5f && mesh.colours.at(0).x < 1.0f);
    QCOMPARE(mesh.colours.at(2).x, 0.0f);
}

void GltfTest::wrongNumbers_data() {
    QTest::addColumn<QString>("attribute");
    QTest::addColumn<int>("type");
    QTest::addColumn<QString>("shape");
    QTest::addColumn<QString>("message");
    QTest::newRow("flat") << "POSITION" << kFloatNumbers << "VEC2"
                          << "POSITION is of the type VEC2, not VEC3";
    QTest::newRow("line") << "POSITION" << kShort << "SCALAR"
                          << "POSITION is of the type SCALAR, not VEC3";
    QTest::newRow("more") << "NORMAL" << kFloatNumbers << "VEC4"
                          << "NORMAL is of the type VEC4, not VEC3";
    QTest::newRow("few") << "TEXCOORD_0" << kFloatNumbers << "SCALAR"
                         << "TEXCOORD_0 is of the type SCALAR, not VEC2";
    QTest::newRow("large") << "POSITION" << kUnsigned << "VEC3"
                           << "POSITION is of numbers of the component type 5125, not of floats";
    QTest::newRow("doubles") << "POSITION" << 5130 << "VEC3"
                             << "POSITION is of numbers of the component type 5130, not of floats";
}

void GltfTest::wrongNumbers() {
    QFETCH(QString, attribute);
    QFETCH(int, type);
    QFETCH(QString, shape);
    QFETCH(QString, message);
    GltfFile file = triangleFile();
    file.attributes[attribute] =
        file.accessor(file.view(std::string(48, '\0')), type, shape.toLatin1().constData(), 3);
    const Result<ImportedMesh> read = importMesh(write(QStringLiteral("w.gltf"), file.text()));
    QVERIFY(!read.ok());
    QVERIFY2(messageOf(read).contains(message), qPrintable(messageOf(read)));
}

void GltfTest::extensions_data() {
    QTest::addColumn<QString>("more");
    QTest::addColumn<bool>("isRead");
    QTest::addColumn<QString>("message");
    QTest::newRow("unknown") << R"({"extensionsRequired": ["FOO_bar"]})" << false
                             << "it needs the extension FOO_bar, which Hitscope cannot read";
    QTest::newRow("unknown ones") << R"({"extensionsRequired": ["A_b", "KHR_materials_unlit", "C_d"]})"
                                  << false << "it needs the extensions A_b, C_d, which Hitscope cannot read";
    QTest::newRow("unknown, not needed") << R"({"extensionsUsed": ["FOO_bar"]})" << true << "";
    QTest::newRow("compressed") << R"({"extensionsRequired": ["EXT_meshopt_compression"]})" << false
                                << "it needs the extension EXT_meshopt_compression";
    const QString instanced = QStringLiteral(R"({"%1": ["EXT_mesh_gpu_instancing"],
        "nodes": [{"mesh": 0, "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 0}}}}]})");
    QTest::newRow("instances") << instanced.arg(QLatin1String("extensionsRequired")) << false
                               << "EXT_mesh_gpu_instancing";
    QTest::newRow("instances, not needed")
        << instanced.arg(QLatin1String("extensionsUsed")) << true
        << "Of instances that lie in numbers (EXT_mesh_gpu_instancing) only the mesh itself was read.";
    QTest::newRow("materials") << R"({"extensionsRequired": ["KHR_materials_ior", "KHR_lights_punctual"]})"
                               << true << "";
    const QString moved = QStringLiteral(R"({"extensionsRequired": ["KHR_texture_transform"],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0,
        "extensions": {"KHR_texture_transform": {"scale": [%1, 1]}}}}}],
        "images": [{"uri": "moved.png"}], "textures": [{"source": 0}]})");
    QTest::newRow("textures moved") << moved.arg(2) << true << "";
    QTest::newRow("pictures")
        << R"({"extensionsRequired": ["KHR_texture_basisu"], "images": [{"uri": "a.ktx2"}],
               "textures": [{"extensions": {"KHR_texture_basisu": {"source": 0}}}]})"
        << true << "Textures of a kind that cannot be read (KHR_texture_basisu) are not shown.";
}

void GltfTest::extensions() {
    QFETCH(QString, more);
    QFETCH(bool, isRead);
    QFETCH(QString, message);
    write(QStringLiteral("moved.png"), smallPng().toStdString());
    GltfFile file = triangleFile();
    file.more = members(more.toUtf8().constData());
    const Result<ImportedMesh> read = importMesh(write(QStringLiteral("e.gltf"), file.text()));
    QCOMPARE(read.ok(), isRead);
    QVERIFY2(messageIn(read).contains(message), qPrintable(messageIn(read)));
    QCOMPARE(isRead && read.value().notes.isEmpty(), isRead && message.isEmpty());
}

void GltfTest::scenes_data() {
    QTest::addColumn<QString>("more");
    QTest::addColumn<QString>("message");
    QTest::newRow("none") << R"({"scenes": null, "nodes": [{"mesh": 0, "translation": [0, 0, 5]},
                                 {"children": [0], "translation": [0, 0, 2]}]})"
                          << "";
    QTest::newRow("empty list") << R"({"scenes": [], "nodes": [{"mesh": 0, "translation": [0, 0, 7]}]})"
                                << "";
    QTest::newRow("another's mesh") << R"({"nodes": [{"mesh": 0, "translation": [0, 0, 7]}, {"mesh": 1}],
               "scenes": [{"nodes": [1]}, {"nodes": [0]}], "scene": 1,
               "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]},
                          {"primitives": [{"attributes": {"POSITION": 0}}]}]})"
                                    << "";
    QTest::newRow("empty") << R"({"scenes": [{"nodes": []}]})"
                           << "its scene is empty. Put the meshes into";
    QTest::newRow("without meshes") << R"({"nodes": [{}]})"
                                    << "no node of its scene has a mesh. Put";
    QTest::newRow("no nodes") << R"({"nodes": [], "scenes": null})"
                              << "it has no nodes, so that nothing places";
    QTest::newRow("no such mode")
        << R"({"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "mode": 7}]}]})"
        << "a mesh is of the mode 7, of which glTF has 0 to 6";
    QTest::newRow("no such scene") << R"({"scene": 3})"
                                   << "it refers to a scene that it does not have";
}

void GltfTest::scenes() {
    QFETCH(QString, more);
    QFETCH(QString, message);
    GltfFile file = triangleFile();
    file.more = members(more.toUtf8().constData());
    for (const bool isBinary : {false, true}) {
        const Result<ImportedMesh> read = importMesh(isBinary ? write(QStringLiteral("s.glb"), file.glb())
                                                              : write(QStringLiteral("s.gltf"), file.text()));
        QCOMPARE(read.ok(), message.isEmpty());
        QVERIFY2(messageOf(read).contains(message), qPrintable(messageOf(read)));
        if (read.ok()) {
            QCOMPARE(read.value().mesh.positions[1], glm::vec3(100, 0, 7));
        }
    }
}

HITSCOPE_TEST(GltfTest, QCoreApplication)

}  // namespace hitscope::io_gltf_test

#include "io_gltf_test.moc"
