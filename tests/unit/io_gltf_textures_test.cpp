// SPDX-License-Identifier: GPL-3.0-or-later
// Texture coordinates of glTF files, as KHR_texture_transform moves them.
#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>

#include "gltf_support.h"
#include "io/import.h"
#include "io_support.h"
#include "support/test_program.h"

namespace hitscope::io_gltf_textures_test {

using namespace test;

class GltfTexturesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        writeFile(m_folder->path(), QStringLiteral("a.png"), smallPng().toStdString());
    }
    void moved_data();
    void moved();
    void eachMaterialMovesItsOwn();
    void materialsShareVertices();
    void mixedOnesAreNoted();

private:
    /// A triangle at (0, 0), (1, 0), (0, 1) of the texture; v points down.
    static GltfFile textured(int kind);
    [[nodiscard]] Result<ImportedMesh> read(const GltfFile& file) const {
        return importMesh(writeFile(m_folder->path(), QStringLiteral("t.gltf"), file.text()));
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

GltfFile GltfTexturesTest::textured(int kind) {
    GltfFile file = triangleFile();
    std::string bytes;
    for (const auto& [u, v] : {std::pair{0, 0}, std::pair{1, 0}, std::pair{0, 1}}) {
        if (kind == kFloatNumbers) {
            put(bytes, static_cast<float>(u), static_cast<float>(v));
        } else {
            put(bytes, static_cast<std::uint16_t>(65535 * u), static_cast<std::uint16_t>(65535 * v));
        }
    }
    file.attributes[QStringLiteral("TEXCOORD_0")] = file.accessor(
        file.view(bytes), kind, "VEC2", 3, {{QStringLiteral("normalized"), kind != kFloatNumbers}});
    file.primitive[QStringLiteral("material")] = 0;
    return file;
}

QJsonObject materials(const QByteArray& json) {
    QJsonObject members = QJsonDocument::fromJson(json).object();
    members[QStringLiteral("images")] =
        QJsonArray{QJsonObject{{QStringLiteral("uri"), QStringLiteral("a.png")}}};
    members[QStringLiteral("textures")] = QJsonArray{QJsonObject{{QStringLiteral("source"), 0}}};
    return members;
}

void GltfTexturesTest::moved_data() {
    QTest::addColumn<QByteArray>("transform");
    QTest::addColumn<int>("kind");
    QTest::addColumn<QList<double>>("texcoords");  // of the three corners, v up
    QTest::newRow("not") << QByteArray("{}") << kFloatNumbers << QList<double>{0, 1, 1, 1, 0, 0};
    QTest::newRow("offset") << QByteArray(R"({"offset": [0.5, 0.25]})") << kFloatNumbers
                            << QList<double>{0.5, 0.75, 1.5, 0.75, 0.5, -0.25};
    QTest::newRow("scale") << QByteArray(R"({"scale": [2, 3]})") << kFloatNumbers
                           << QList<double>{0, 1, 2, 1, 0, -2};
    // As the specification's own test file shows it: a quarter turns u to -v.
    QTest::newRow("rotation") << QByteArray(R"({"rotation": 1.5707963267948966})") << kFloatNumbers
                              << QList<double>{0, 1, 0, 2, 1, 1};
    QTest::newRow("quantised") << QByteArray(R"({"scale": [2, 3], "offset": [0.5, 0]})") << kUnsignedShort
                               << QList<double>{0.5, 1, 2.5, 1, 0.5, -2};
}

void GltfTexturesTest::moved() {
    QFETCH(const QByteArray, transform);
    QFETCH(const int, kind);
    QFETCH(const QList<double>, texcoords);
    GltfFile file = textured(kind);
    file.more = materials(R"({"materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0,
                              "extensions": {"KHR_texture_transform": )" +
                          transform + "}}}}]}");
    const Result<ImportedMesh> imported = read(file);
    QVERIFY2(imported.ok(), qPrintable(messageOf(imported)));
    QVERIFY(imported.value().notes.isEmpty());
    const MeshData& mesh = imported.value().mesh;
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const glm::vec2 is = mesh.texcoords.at(mesh.cornerTexcoords.at(corner));
        const glm::dvec2 meant(texcoords[static_cast<qsizetype>(2 * corner)],
                               texcoords[static_cast<qsizetype>(2 * corner + 1)]);
        QVERIFY2(glm::distance(glm::dvec2(is), meant) < 1.0e-6,
                 qPrintable(QStringLiteral("%1 %2").arg(is.x).arg(is.y)));
    }
}

/// Two materials over the same numbers, of which Assimp meets the second one first.
void GltfTexturesTest::eachMaterialMovesItsOwn() {
    GltfFile file = textured(kFloatNumbers);
    file.more = materials(R"({"materials": [
        {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}},
        {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "extensions": {
            "KHR_texture_transform": {"offset": [7, 0]}}}}}],
        "meshes": [{"primitives": [
            {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 1},
            {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}]}]})");
    const Result<ImportedMesh> imported = read(file);
    QVERIFY2(imported.ok(), qPrintable(messageOf(imported)));
    const MeshData& mesh = imported.value().mesh;
    QCOMPARE(mesh.faceCount(), std::size_t{2});
    QCOMPARE(mesh.texcoords[mesh.cornerTexcoords[0]].x, 7.0f);
    QCOMPARE(mesh.texcoords[mesh.cornerTexcoords[3]].x, 0.0f);
}

/// As many exporters write them: each material has some faces of one list of vertices.
void GltfTexturesTest::materialsShareVertices() {
    GltfFile file;
    std::string corners;
    for (const auto& [x, y] : {std::pair{0, 0}, std::pair{1, 0}, std::pair{0, 1}, std::pair{1, 1}}) {
        put(corners, static_cast<float>(x), static_cast<float>(y), 0.0f);
    }
    file.attributes[QStringLiteral("POSITION")] = file.accessor(
        file.view(corners), kFloatNumbers, "VEC3", 4,
        {{QStringLiteral("min"), QJsonArray{0, 0, 0}}, {QStringLiteral("max"), QJsonArray{1, 1, 0}}});
    std::string first;
    put(first, std::uint16_t{0}, std::uint16_t{1}, std::uint16_t{2}, std::uint16_t{0});
    std::string second;
    put(second, std::uint16_t{1}, std::uint16_t{3}, std::uint16_t{2}, std::uint16_t{0});
    file.accessor(file.view(first), kUnsignedShort, "SCALAR", 3);
    file.accessor(file.view(second), kUnsignedShort, "SCALAR", 3);
    file.more = materials(R"({"materials": [
        {"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}},
        {"pbrMetallicRoughness": {"baseColorFactor": [0, 1, 0, 1]}}], "meshes": [{"primitives": [
        {"attributes": {"POSITION": 0}, "indices": 1, "material": 0},
        {"attributes": {"POSITION": 0}, "indices": 2, "material": 1}]}]})");
    const Result<ImportedMesh> imported = read(file);
    QVERIFY2(imported.ok(), qPrintable(messageOf(imported)));
    const MeshData& mesh = imported.value().mesh;
    QCOMPARE(mesh.positions.size(), std::size_t{4});
    QCOMPARE(mesh.faceCount(), std::size_t{2});
    QCOMPARE(mesh.faceMaterials, (std::vector<std::uint32_t>{0, 1}));
    QCOMPARE(mesh.cornerVertices, (std::vector<std::uint32_t>{0, 1, 2, 1, 3, 2}));
}

void GltfTexturesTest::mixedOnesAreNoted() {
    GltfFile file = textured(kFloatNumbers);
    file.more = materials(R"({"materials": [{"normalTexture": {"index": 0}, "pbrMetallicRoughness": {
        "baseColorTexture": {"index": 0, "extensions": {"KHR_texture_transform": {"scale": [2, 2]}}}}}]})");
    const Result<ImportedMesh> imported = read(file);
    QVERIFY2(imported.ok(), qPrintable(messageOf(imported)));
    QCOMPARE(imported.value().notes.size(), 1);
    QVERIFY(imported.value().notes[0].contains(QStringLiteral("KHR_texture_transform")));
    const MeshData& mesh = imported.value().mesh;
    QCOMPARE(mesh.texcoords[mesh.cornerTexcoords[1]].x, 2.0f);
}

HITSCOPE_TEST(GltfTexturesTest, QCoreApplication)

}  // namespace hitscope::io_gltf_textures_test

#include "io_gltf_textures_test.moc"
