// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "io/import.h"
#include "io_support.h"
#include "support/test_program.h"

namespace hitscope::io_formats_test {

using namespace test;
using Indices = std::vector<std::uint32_t>;

namespace {

QString data(const char* name) {
    return QDir(QStringLiteral(HITSCOPE_TEST_DATA)).filePath(QString::fromLatin1(name));
}

ImportedMesh imported(const QString& path) {
    const Result<ImportedMesh> result = importMesh(path);
    if (!result) {
        qWarning("%s", result.error().message().c_str());
        return {};
    }
    return result.value();
}

/// The numbers that a glTF holds as base64, and where that text stands in it.
struct InlineNumbers {
    std::string bytes;
    std::size_t first = 0;
    std::size_t size = 0;
};

InlineNumbers findNumbers(const std::string& gltf) {
    const std::string start = "data:application/octet-stream;base64,";
    InlineNumbers found;
    found.first = gltf.find(start);
    found.size = gltf.find('"', found.first) - found.first;
    const std::string base64 = gltf.substr(found.first + start.size(), found.size - start.size());
    found.bytes = QByteArray::fromBase64(QByteArray::fromStdString(base64)).toStdString();
    return found;
}

void putChunk(std::string& file, std::string content, const char* type, char padding) {
    content.resize((content.size() + 3) / 4 * 4, padding);
    put(file, static_cast<std::uint32_t>(content.size()));
    file.append(type, 4).append(content);
}

/// The same as a binary glTF: a header, the text and the numbers.
std::string glbOf(std::string gltf) {
    const InlineNumbers numbers = findNumbers(gltf);
    const std::string uri = ",\n   \"uri\": \"";
    const std::size_t from = numbers.first - uri.size();
    gltf.erase(from, uri.size() + numbers.size + 1);
    std::string chunks;
    putChunk(chunks, gltf, "JSON", ' ');
    putChunk(chunks, numbers.bytes, "BIN\0", '\0');
    std::string file = "glTF";
    put(file, std::uint32_t{2}, static_cast<std::uint32_t>(chunks.size() + 12));
    return file + chunks;
}

std::string chunk3ds(std::uint16_t id, const std::string& content) {
    std::string chunk;
    put(chunk, id, static_cast<std::uint32_t>(content.size() + 6));
    return chunk + content;
}

/// Two triangles with a common edge, in 3D Studio's nested chunks.
std::string small3ds() {
    std::string vertices;
    put(vertices, std::uint16_t{4});
    put(vertices, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 1.0f, 1.0f, 0.0f);
    std::string faces;
    put(faces, std::uint16_t{2});
    for (const auto& [a, b, c] : {std::tuple{0, 1, 2}, std::tuple{2, 1, 3}}) {
        put(faces, static_cast<std::uint16_t>(a), static_cast<std::uint16_t>(b),
            static_cast<std::uint16_t>(c), std::uint16_t{7});
    }
    const std::string mesh = chunk3ds(0x4100, chunk3ds(0x4110, vertices) + chunk3ds(0x4120, faces));
    return chunk3ds(0x4D4D, chunk3ds(0x3D3D, chunk3ds(0x4000, std::string("sheet") + '\0' + mesh)));
}

}  // namespace

class FormatsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void obj();
    void plyAndStl();
    void off();
    void gltf_data();
    void gltf();
    void externalFilesOfGltf();
    void normalMapOfGltf();
    void metalnessAndRoughnessOfGltf();
    void otherMaterialsOfGltf();
    void coloursOfGltf();
    void normalMapOfFbx();
    void dae();
    void fbx();
    void threeDs();
    void suffixInCapitals();
    void listsFormats();

private:
    QTemporaryDir m_folder;
};

void FormatsTest::obj() {
    writeFile(m_folder.path(), QStringLiteral("w.png"), smallPng().toStdString());
    writeFile(m_folder.path(), QStringLiteral("a.mtl"), "newmtl wood\nKd 1 0 0\nmap_Kd w.png\n");
    const ImportedMesh result = imported(writeFile(
        m_folder.path(), QStringLiteral("a b.c.obj"),
        "mtllib a.mtl\no body\nv 0.1 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl wood\nf 1 2 3 4\nf 1\nl 1 2\n"));
    QCOMPARE(result.mesh.name, std::string("a b.c"));
    QCOMPARE(result.mesh.faceStarts, (Indices{0, 4}));
    QVERIFY(result.mesh.filePositions.at(0) == glm::dvec3(0.1, 0, 0));
    QCOMPARE(result.mesh.materials.at(0).diffuse, glm::vec3(1, 0, 0));
    QCOMPARE(result.mesh.images.at(0).width, 2);
    QCOMPARE(result.mesh.lines.size(), std::size_t(1));
    QCOMPARE(result.mesh.groups.at(0).name, std::string("body"));
    QCOMPARE(result.notes, QStringList{QStringLiteral("1 face with fewer than three corners was left out.")});
}

void FormatsTest::plyAndStl() {
    const QString ply =
        writeFile(m_folder.path(), QStringLiteral("a.ply"),
                  "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                  "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                  "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    QCOMPARE(imported(ply).mesh.cornerVertices, (Indices{0, 1, 2}));
    const QString stl =
        writeFile(m_folder.path(), QStringLiteral("a.stl"),
                  "solid a\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
                  "endfacet\nendsolid\n");
    QCOMPARE(imported(stl).mesh.cornerVertices, (Indices{0, 1, 2}));
}

void FormatsTest::off() {
    const MeshData mesh = imported(data("two_quads.off")).mesh;
    QCOMPARE(mesh.vertexCount(), std::size_t(7));
    QCOMPARE(mesh.positions[6], glm::vec3(9, 9, 9));
    QCOMPARE(mesh.faceStarts, (Indices{0, 4, 8}));
    QCOMPARE(mesh.cornerVertices, (Indices{0, 1, 2, 3, 1, 4, 5, 2}));
    const MeshData rich =
        imported(writeFile(m_folder.path(), QStringLiteral("a.off"),
                           "STCNOFF 3 2 9\n0 0 0 0 0 1 255 0 0 255 0.5 1\n"
                           "1 0 0 0 0 1 0 51 0 0 1 0.5 # comment\n\n0 1 0 0 0 1 0 0 0 9 0 0\n"
                           "3 0 1 2 255 0 0\n2 0 1\n"))
            .mesh;
    QCOMPARE(rich.faceStarts, (Indices{0, 3}));
    QCOMPARE(rich.colours.at(1), glm::vec3(0, 0.2f, 0));
    QCOMPARE(rich.texcoords.at(1), glm::vec2(1, 0.5f));
    QCOMPARE(rich.cornerNormals, (Indices{0, 1, 2}));
}

void FormatsTest::gltf_data() {
    QTest::addColumn<bool>("binary");
    QTest::newRow("gltf") << false;
    QTest::newRow("glb") << true;
}

void FormatsTest::gltf() {
    QFETCH(bool, binary);
    const std::string text = readFile(data("two_quads.gltf"));
    const QString path =
        writeFile(m_folder.path(), binary ? QStringLiteral("a.glb") : QStringLiteral("a.gltf"),
                  binary ? glbOf(text) : text);
    const ImportedMesh result = imported(path);
    const MeshData& mesh = result.mesh;
    QCOMPARE(mesh.positions,
             (PageVector<glm::vec3>{
                 {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {10, 0, 0}, {9, 0, 0}, {10, 1, 0}, {9, 1, 0}}));
    // The mirrored node's triangles are turned, so that they still face the same way.
    QCOMPARE(mesh.cornerVertices, (Indices{0, 1, 2, 2, 1, 3, 6, 5, 4, 7, 5, 6}));
    QCOMPARE(mesh.groups.size(), std::size_t(2));
    QCOMPARE(mesh.groups[1].name, std::string("mirrored"));
    QCOMPARE(mesh.groups[1].firstFace, 2u);
    // glTF counts v downwards; the first vertex is its picture's lower left corner.
    QCOMPARE(mesh.texcoords.at(0), glm::vec2(0, 0));
    QCOMPARE(mesh.texcoords.at(3), glm::vec2(1, 1));
    QCOMPARE(mesh.materials.size(), std::size_t(1));
    const Material& paint = mesh.materials.at(mesh.faceMaterials.at(0));
    QCOMPARE(paint.name, std::string("paint"));
    QCOMPARE(paint.diffuse, glm::vec3(1, 0.5f, 0));
    QCOMPARE(mesh.images.at(static_cast<std::size_t>(paint.diffuseImage)).pixels,
             (std::vector<std::uint8_t>{255, 0, 0, 255, 0, 255, 0, 255}));  // its material is opaque
    QCOMPARE(result.notes, QStringList());
}

void FormatsTest::externalFilesOfGltf() {
    // The same with its numbers in a file of its own: beside the mesh they are found, outside they are not.
    QVERIFY(QDir(m_folder.path()).mkpath(QStringLiteral("inner")));
    const std::string text = readFile(data("two_quads.gltf"));
    const InlineNumbers numbers = findNumbers(text);
    const std::string inside = std::string(text).replace(numbers.first, numbers.size, "numbers.bin");
    const std::string outside = std::string(text).replace(numbers.first, numbers.size, "../numbers.bin");
    writeFile(m_folder.path(), QStringLiteral("numbers.bin"), numbers.bytes);
    const QString outsidePath = writeFile(m_folder.path(), QStringLiteral("inner/outside.gltf"), outside);
    QVERIFY(!importMesh(outsidePath));
    writeFile(m_folder.path(), QStringLiteral("inner/numbers.bin"), numbers.bytes);
    const QString insidePath = writeFile(m_folder.path(), QStringLiteral("inner/inside.gltf"), inside);
    QCOMPARE(imported(insidePath).mesh.faceCount(), std::size_t(4));
}

void FormatsTest::normalMapOfGltf() {
    writeFile(m_folder.path(), QStringLiteral("bumps.png"), smallPng().toStdString());
    std::string text = readFile(data("two_quads.gltf"));
    const auto put = [&text](std::string_view before, std::string_view added) {
        text.insert(text.find(before) + before.size(), added);
    };
    put("\"name\": \"paint\",", "\"normalTexture\": {\"index\": 1, \"scale\": 0.5},");
    put("\"textures\": [", "{\"source\": 0}, {\"source\": 1}, ");
    text.insert(text.find(']', text.find("\"images\": [")), ", {\"uri\": \"bumps.png\"}");
    const MeshData mesh = imported(writeFile(m_folder.path(), QStringLiteral("bumps.gltf"), text)).mesh;
    const NormalMap& map = mesh.materials.at(mesh.faceMaterials.at(0)).normalMap;
    QCOMPARE(map.kind, NormalMap::Kind::Normals);
    QCOMPARE(map.texture, std::string("bumps.png"));
    QCOMPARE(map.strength, 0.5f);
    QCOMPARE(mesh.images.at(static_cast<std::size_t>(map.image)).width, 2);
    QVERIFY(map.image != mesh.materials.at(mesh.faceMaterials.at(0)).diffuseImage);
}

void FormatsTest::metalnessAndRoughnessOfGltf() {
    writeFile(m_folder.path(), QStringLiteral("rough.png"), smallPng().toStdString());
    const std::string plain = readFile(data("two_quads.gltf"));
    const auto read = [&](std::string_view added) {
        std::string text = plain;
        const std::string_view before = "\"pbrMetallicRoughness\": {";
        text.insert(text.find(before) + before.size(), added);
        const std::string_view textures = "\"textures\": [";
        text.insert(text.find(textures) + textures.size(), "{\"source\": 0}, {\"source\": 1}, ");
        text.insert(text.find(']', text.find("\"images\": [")), ", {\"uri\": \"rough.png\"}");
        return imported(writeFile(m_folder.path(), QStringLiteral("metal.gltf"), text)).mesh;
    };
    const MeshData mesh = read(
        "\"metallicFactor\": 0.25, \"roughnessFactor\": 0.5, "
        "\"metallicRoughnessTexture\": {\"index\": 1},");
    const MetalRoughness& metal = mesh.materials.at(0).metalRoughness;
    QCOMPARE(metal.metalness, 0.25f);
    QCOMPARE(metal.roughness, 0.5f);
    QCOMPARE(metal.texture, std::string("rough.png"));
    QCOMPARE(mesh.images.at(static_cast<std::size_t>(metal.image)).width, 2);
    QVERIFY(metal.image != mesh.materials.at(0).diffuseImage);
    // What the format says of a material that says nothing itself.
    const MetalRoughness usual = read("").materials.at(0).metalRoughness;
    QCOMPARE(usual.metalness, 1.0f);
    QCOMPARE(usual.roughness, 1.0f);
    QCOMPARE(usual.image, -1);
    // A picture in the file itself.
    const MeshData embedded = read("\"metallicRoughnessTexture\": {\"index\": 0},");
    QVERIFY(embedded.materials.at(0).metalRoughness.texture.empty());
    QCOMPARE(embedded.materials.at(0).metalRoughness.image, embedded.materials.at(0).diffuseImage);
}

void FormatsTest::otherMaterialsOfGltf() {
    const std::string plain = readFile(data("two_quads.gltf"));
    const auto read = [&](std::string_view before, std::string_view added) {
        std::string text = plain;
        text.insert(text.find(before), added);
        text.insert(1,
                    R"("extensionsUsed": ["KHR_materials_unlit", "KHR_materials_pbrSpecularGlossiness"],)");
        return imported(writeFile(m_folder.path(), QStringLiteral("other.gltf"), text)).mesh;
    };
    const std::string_view paint = "\"name\": \"paint\",";
    const Material unlit = read(paint, R"("extensions": {"KHR_materials_unlit": {}},)").materials.at(0);
    QVERIFY(!unlit.metalRoughness.isGiven());
    QCOMPARE(unlit.specular, glm::vec3(0));
    const Material glossy = read(paint, R"("extensions": {"KHR_materials_pbrSpecularGlossiness": {
        "diffuseFactor": [0.25, 0.5, 0.75, 1], "specularFactor": [0.5, 0.25, 0.125], "glossinessFactor": 0.5}},)")
                                .materials.at(0);
    QVERIFY(!glossy.metalRoughness.isGiven());
    QCOMPARE(glossy.diffuse, glm::vec3(0.25f, 0.5f, 0.75f));
    QCOMPARE(glossy.specular, glm::vec3(0.5f, 0.25f, 0.125f));
    // Opacity counts where the file blends.
    std::string text = plain;
    const std::size_t opacity = text.rfind('1', text.find(']', text.find("baseColorFactor")));
    text.replace(opacity, 1, "0.25");
    const auto opacityOf = [&](const std::string& mesh) {
        return imported(writeFile(m_folder.path(), QStringLiteral("o.gltf"), mesh))
            .mesh.materials.at(0)
            .opacity;
    };
    QCOMPARE(opacityOf(text), 1.0f);
    text.insert(text.find(paint), R"("alphaMode": "BLEND",)");
    QCOMPARE(opacityOf(text), 0.25f);
    const MeshData masked = read(paint, R"("alphaMode": "MASK",)");
    QCOMPARE(masked.images.at(0).pixels.at(7), std::uint8_t{128});
    // Parts without a material have none.
    std::string bare = plain;
    const std::string_view given = ",\n     \"material\": 0";
    QVERIFY(bare.find(given) != std::string::npos);
    bare.erase(bare.find(given), given.size());
    const MeshData mesh = imported(writeFile(m_folder.path(), QStringLiteral("bare.gltf"), bare)).mesh;
    QVERIFY(mesh.faceMaterials.empty() || mesh.faceMaterials.at(0) == kNoIndex);
}

void FormatsTest::coloursOfGltf() {
    // They are linear there; those of a MeshData are sRGB, as OBJ and PLY have them.
    const std::vector<glm::vec3> linear(4, glm::vec3(0.21586f, 0.0f, 1.0f));
    const QByteArray bytes(reinterpret_cast<const char*>(linear.data()),
                           static_cast<qsizetype>(linear.size() * sizeof(glm::vec3)));
    std::string text = readFile(data("two_quads.gltf"));
    const auto put = [&text](std::string_view before, const std::string& added) {
        text.insert(text.find(before) + before.size(), added);
    };
    put("\"attributes\": {", "\"COLOR_0\": 3, ");
    put("\"buffers\": [", R"({"byteLength": 48, "uri": "data:application/octet-stream;base64,)" +
                              bytes.toBase64().toStdString() + "\"}, ");
    for (int view = 0; view < 3; ++view) {  // their buffer is the second one now
        text.replace(text.find("\"buffer\": 0"), 11, "\"buffer\": 1");
    }
    text.insert(text.find(']', text.find("\"bufferViews\"")), R"(, {"buffer": 0, "byteLength": 48})");
    text.insert(text.rfind(']'), R"(, {"bufferView": 3, "componentType": 5126, "count": 4, "type": "VEC3"})");
    const MeshData mesh = imported(writeFile(m_folder.path(), QStringLiteral("c.gltf"), text)).mesh;
    QCOMPARE(mesh.colours.size(), mesh.positions.size());
    QVERIFY(!mesh.colours.empty());
    for (const glm::vec3& colour : mesh.colours) {
        QVERIFY(std::abs(colour.x - 128.0f / 255.0f) < 1.0e-4f);
        QCOMPARE(colour.y, 0.0f);
        QCOMPARE(colour.z, 1.0f);
    }
}

void FormatsTest::normalMapOfFbx() {
    writeFile(m_folder.path(), QStringLiteral("bumps.png"), smallPng().toStdString());
    std::string text = readFile(data("quad.fbx"));
    text.insert(text.rfind('}', text.find("Connections:")), R"(	Texture: 4000, "Texture::bumps", "" {
		Type: "TextureVideoClip"
		Version: 202
		TextureName: "Texture::bumps"
		FileName: "bumps.png"
		RelativeFilename: "bumps.png"
	}
)");
    text.insert(text.rfind('}'), "	C: \"OP\",4000,3000, \"NormalMap\"\n");
    const MeshData mesh = imported(writeFile(m_folder.path(), QStringLiteral("bumps.fbx"), text)).mesh;
    const NormalMap& map = mesh.materials.at(mesh.faceMaterials.at(0)).normalMap;
    QCOMPARE(map.texture, std::string("bumps.png"));
    QCOMPARE(map.strength, 1.0f);
    QCOMPARE(mesh.images.at(static_cast<std::size_t>(map.image)).width, 2);
}

void FormatsTest::dae() {
    const MeshData mesh = imported(data("quad.dae")).mesh;
    // Its reader gives each corner a vertex of its own; equal ones are one again.
    QCOMPARE(mesh.positions,
             (PageVector<glm::vec3>{{10, 0, 0}, {11, 0, 0}, {11, 1, 0}, {10, 1, 0}, {12, 0.5f, 0}}));
    QCOMPARE(mesh.faceStarts, (Indices{0, 4, 7}));
    QCOMPARE(mesh.cornerVertices, (Indices{0, 1, 2, 3, 1, 4, 2}));
    QCOMPARE(mesh.texcoords.at(mesh.cornerTexcoords.at(4)), glm::vec2(0, 0));
    QCOMPARE(mesh.texcoords.at(mesh.cornerTexcoords.at(1)), glm::vec2(1, 0));
    QCOMPARE(mesh.groups.at(0).name, std::string("moved"));
    QCOMPARE(mesh.materials.at(mesh.faceMaterials.at(0)).diffuse, glm::vec3(1, 0.25f, 0));
}

void FormatsTest::fbx() {
    const MeshData mesh = imported(data("quad.fbx")).mesh;
    QCOMPARE(mesh.positions,
             (PageVector<glm::vec3>{{10, 0, 0}, {11, 0, 0}, {11, 1, 0}, {10, 1, 0}, {12, 0.5f, 0}}));
    QCOMPARE(mesh.faceStarts, (Indices{0, 4, 7}));
    QCOMPARE(mesh.cornerVertices, (Indices{0, 1, 2, 3, 1, 4, 2}));
    QCOMPARE(mesh.texcoords.at(mesh.cornerTexcoords.at(2)), glm::vec2(1, 1));
    QCOMPARE(mesh.materials.at(mesh.faceMaterials.at(0)).diffuse, glm::vec3(1, 0.25f, 0));
}

void FormatsTest::threeDs() {
    const MeshData mesh = imported(writeFile(m_folder.path(), QStringLiteral("a.3ds"), small3ds())).mesh;
    QCOMPARE(mesh.vertexCount(), std::size_t(4));
    QCOMPARE(mesh.faceCount(), std::size_t(2));
    QCOMPARE(mesh.cornerVertices, (Indices{0, 1, 2, 2, 1, 3}));
}

void FormatsTest::suffixInCapitals() {
    const QString path =
        writeFile(m_folder.path(), QStringLiteral("LOUD.OBJ"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    QCOMPARE(imported(path).mesh.faceCount(), std::size_t(1));
}

void FormatsTest::listsFormats() {
    for (const char* const suffix : {"obj", "ply", "stl", "gltf", "glb", "off", "fbx", "3ds", "dae"}) {
        QVERIFY(importSuffixes().contains(QString::fromLatin1(suffix)));
        QVERIFY(importNameFilters().first().contains(QStringLiteral("*.") + QString::fromLatin1(suffix)));
    }
}

HITSCOPE_TEST(FormatsTest, QCoreApplication)

}  // namespace hitscope::io_formats_test

#include "io_formats_test.moc"
