// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <functional>
#include <limits>

#include "mesh/mesh_data.h"
#include "mesh/primitives.h"
#include "mesh_support.h"
#include "support/test_program.h"

namespace hitscope::mesh_data_test {

using Damage = std::function<void(MeshData&)>;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// A mesh that has something of everything.
MeshData fullMesh() {
    MeshData mesh = makeCube(1, 1.0f);
    mesh.filePositions.assign(mesh.positions.begin(), mesh.positions.end());
    mesh.colours.assign(mesh.positions.size(), glm::vec3(0.5f));
    mesh.faceMaterials.assign(mesh.faceCount(), 0);
    mesh.faceMaterials.back() = kNoIndex;
    mesh.faceSmoothing.assign(mesh.faceCount(), 1);
    mesh.groups = {{FaceGroup::Kind::Object, "cube", 0}, {FaceGroup::Kind::Group, "side", 3}};
    mesh.materials.resize(1);
    mesh.materials[0].diffuseImage = 0;
    mesh.images.push_back({2, 1, std::vector<std::uint8_t>(8)});
    mesh.lines = {{0, 1, 2}};
    mesh.points = {7};
    return mesh;
}

}  // namespace

class MeshDataTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void soundMeshesPass() {
        QVERIFY(validate(fullMesh()).ok());
        QVERIFY(validate(MeshData()).ok());
        QVERIFY(validate(makeHighPolySphere()).ok());
    }

    void damageIsNamed_data() {
        QTest::addColumn<Damage>("damage");
        QTest::addColumn<QString>("where");
        const auto row = [](const char* name, const char* where, Damage damage) {
            QTest::newRow(name) << std::move(damage) << QString(where);
        };
        row("nan", "vertex 3", [](MeshData& m) { m.positions[2].y = kNan; });
        row("infinite", "vertex 1", [](MeshData& m) { m.positions[0].x = 1e30f * 1e30f; });
        row("file positions short", "file positions", [](MeshData& m) { m.filePositions.pop_back(); });
        row("file position nan", "vertex 2", [](MeshData& m) { m.filePositions[1].z = double{kNan}; });
        row("metalness nan", "material 1",
            [](MeshData& m) { m.materials[0].metalRoughness.metalness = kNan; });
        row("roughness", "material 1", [](MeshData& m) { m.materials[0].metalRoughness.roughness = 1.5f; });
        row("no such metal", "material 1", [](MeshData& m) { m.materials[0].metalRoughness.image = 1; });
        row("placement", "placement", [](MeshData& m) { m.placement.scale = 0.0; });
        row("colours short", "vertex colours", [](MeshData& m) { m.colours.pop_back(); });
        row("colour above 1", "vertex 8", [](MeshData& m) { m.colours[7].g = 1.5f; });
        row("colour nan", "vertex 8", [](MeshData& m) { m.colours[7].b = kNan; });
        row("corners without faces", "face corners", [](MeshData& m) { m.faceStarts.clear(); });
        row("first start", "face starts", [](MeshData& m) { m.faceStarts[0] = 1; });
        row("last start", "face starts", [](MeshData& m) { m.faceStarts.back() = 23; });
        row("two corners", "face 2", [](MeshData& m) { m.faceStarts[2] = 6; });
        row("descending", "face 3", [](MeshData& m) { m.faceStarts[3] = 2; });
        row("start beyond the end", "face 1", [](MeshData& m) { m.faceStarts[1] = 4000000000u; });
        row("vertex index", "face 6", [](MeshData& m) { m.cornerVertices[23] = 8; });
        row("no vertex", "face 1", [](MeshData& m) { m.cornerVertices[0] = kNoIndex; });
        row("texture index", "face 2", [](MeshData& m) { m.cornerTexcoords[4] = 4; });
        row("texture indices short", "texture indices of corners",
            [](MeshData& m) { m.cornerTexcoords.pop_back(); });
        row("normal index", "face 3", [](MeshData& m) { m.cornerNormals[8] = 6; });
        row("normal indices long", "normal indices of corners",
            [](MeshData& m) { m.cornerNormals.push_back(0); });
        row("material index", "face 4", [](MeshData& m) { m.faceMaterials[3] = 1; });
        row("materials short", "materials of faces", [](MeshData& m) { m.faceMaterials.pop_back(); });
        row("smoothing short", "smoothing groups of faces", [](MeshData& m) { m.faceSmoothing.pop_back(); });
        row("image index", "material 1", [](MeshData& m) { m.materials[0].diffuseImage = 1; });
        row("image index below -1", "material 1", [](MeshData& m) { m.materials[0].diffuseImage = -2; });
        row("pixels", "texture 1", [](MeshData& m) { m.images[0].pixels.pop_back(); });
        row("negative image", "texture 1",
            [](MeshData& m) { m.images[0].width = -2, m.images[0].height = -1; });
        row("groups out of order", "group 2", [](MeshData& m) { m.groups[0].firstFace = 4; });
        row("group behind the end", "group 2", [](MeshData& m) { m.groups[1].firstFace = 7; });
        row("group kind", "group 1", [](MeshData& m) { m.groups[0].kind = static_cast<FaceGroup::Kind>(9); });
        row("line", "line 1", [](MeshData& m) { m.lines[0][1] = 8; });
        row("point", "point 1", [](MeshData& m) { m.points[0] = 8; });
    }
    void damageIsNamed() {
        QFETCH(Damage, damage);
        QFETCH(QString, where);
        MeshData mesh = fullMesh();
        damage(mesh);
        const Status status = validate(mesh);
        QVERIFY(!status.ok());
        QCOMPARE(QString::fromStdString(status.error().where), where);
        QVERIFY(!status.error().what.empty());
        QVERIFY(!status.error().advice.empty());
    }

    void cornersMayLackTexcoordAndNormal() {
        MeshData mesh = fullMesh();
        mesh.cornerTexcoords[5] = kNoIndex;
        mesh.cornerNormals[5] = kNoIndex;
        QVERIFY(validate(mesh).ok());
    }

    void placingCentresScalesAndRemembers() {
        MeshData mesh = test::meshOf({{10, 20, 30}, {14, 20, 30}, {10, 22, 30}}, {{0, 1, 2}});
        place(mesh, 2.0f);
        QVERIFY(mesh.positions[0] == glm::vec3(-1.0f, -0.5f, 0.0f));
        QVERIFY(mesh.positions[1] == glm::vec3(1.0f, -0.5f, 0.0f));
        QVERIFY(mesh.filePositions[1] == glm::dvec3(14.0, 20.0, 30.0));
        QCOMPARE(mesh.placement.scale, 0.5);
        QVERIFY(mesh.placement.centre == glm::dvec3(12.0, 21.0, 30.0));
        for (std::size_t v = 0; v < 3; ++v) {
            const glm::dvec3 back =
                glm::dvec3(mesh.positions[v]) / mesh.placement.scale + mesh.placement.centre;
            QVERIFY(back == mesh.filePositions[v]);
        }
        QVERIFY(validate(mesh).ok());
    }

    void placingUsesTheFilesOwnNumbers() {
        // A survey's coordinates, finer than float at that distance.
        MeshData mesh = test::meshOf({{4e6f, 0, 0}, {4e6f, 0, 0}, {4e6f, 0, 0}}, {{0, 1, 2}});
        mesh.filePositions = {{4e6, 0.0, 0.0}, {4e6 + 0.125, 0.0, 0.0}, {4e6, 0.0625, 0.0}};
        place(mesh, 1.0f);
        QVERIFY(mesh.positions[1] == glm::vec3(0.5f, -0.25f, 0.0f));
        QVERIFY(mesh.filePositions[1] == glm::dvec3(4e6 + 0.125, 0.0, 0.0));
        place(mesh, 4.0f);  // a second placement starts from the file again
        QVERIFY(mesh.positions[1] == glm::vec3(2.0f, -1.0f, 0.0f));
        QCOMPARE(mesh.placement.scale, 32.0);
    }

    void placingAPointKeepsItsScale() {
        MeshData mesh = test::meshOf({{5, 5, 5}, {5, 5, 5}, {5, 5, 5}}, {{0, 1, 2}});
        place(mesh, 2.0f);
        QCOMPARE(mesh.placement.scale, 1.0);
        QVERIFY(mesh.positions[2] == glm::vec3(0.0f));
        MeshData empty;
        place(empty, 2.0f);
        QVERIFY(empty.placement.isIdentity());
    }
};

HITSCOPE_TEST(MeshDataTest, QCoreApplication)

}  // namespace hitscope::mesh_data_test

#include "mesh_data_test.moc"
