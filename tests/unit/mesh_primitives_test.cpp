// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "mesh/primitives.h"
#include "mesh/surface/surface_topology.h"
#include "support/test_program.h"

namespace hitscope::mesh_primitives_test {

namespace {

SurfaceStatistics statisticsOf(const MeshData& mesh) {
    return SurfaceTopology::build(mesh)->statistics();
}

glm::vec3 faceNormal(const MeshData& mesh, std::size_t f) {
    const auto face = mesh.face(f);
    const glm::vec3 a = mesh.positions[face[0]];
    return glm::normalize(glm::cross(mesh.positions[face[1]] - a, mesh.positions[face[2]] - a));
}

glm::vec3 faceCentre(const MeshData& mesh, std::size_t f) {
    glm::vec3 sum(0.0f);
    for (const std::uint32_t vertex : mesh.face(f)) {
        sum += mesh.positions[vertex];
    }
    return sum / static_cast<float>(mesh.face(f).size());
}

}  // namespace

class PrimitivesTest : public QObject {
    Q_OBJECT

    static void addMeshes() {
        QTest::addColumn<MeshData>("mesh");
        QTest::addColumn<std::size_t>("vertices");
        QTest::addColumn<std::size_t>("faces");
        QTest::newRow("Low-poly cube") << makeLowPolyCube() << std::size_t{386} << std::size_t{6 * 8 * 8};
        QTest::newRow("High-poly cube")
            << makeHighPolyCube() << std::size_t{6146} << std::size_t{6 * 32 * 32};
        QTest::newRow("Low-poly sphere") << makeLowPolySphere() << std::size_t{382} << std::size_t{20 * 20};
        QTest::newRow("High-poly sphere") << makeHighPolySphere() << std::size_t{7938} << std::size_t{7936};
        QTest::newRow("smallest cube") << makeCube(1, 2.5f) << std::size_t{8} << std::size_t{6};
        QTest::newRow("smallest sphere") << makeUvSphere(3, 2, 2.5f) << std::size_t{5} << std::size_t{6};
    }

private Q_SLOTS:
    void areClosedAndLookOutwards_data() { addMeshes(); }
    void areClosedAndLookOutwards() {
        QFETCH(MeshData, mesh);
        QFETCH(std::size_t, vertices);
        QFETCH(std::size_t, faces);
        QVERIFY(validate(mesh).ok());
        QCOMPARE(mesh.vertexCount(), vertices);
        QCOMPARE(mesh.faceCount(), faces);
        const SurfaceStatistics topology = statisticsOf(mesh);
        QVERIFY(topology.isSolid());
        QCOMPARE(topology.eulerCharacteristic, 2LL);
        QCOMPARE(topology.components, std::size_t{1});
        for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
            QVERIFY(glm::dot(faceNormal(mesh, f), faceCentre(mesh, f)) > 0.0f);
        }
    }

    void normalsAndTexcoordsFit_data() { addMeshes(); }
    void normalsAndTexcoordsFit() {
        QFETCH(MeshData, mesh);
        const bool isCoarse = mesh.vertexCount() < 10;
        for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
            glm::vec2 low(2.0f);
            glm::vec2 high(-1.0f);
            for (std::size_t c = mesh.faceStarts[f]; c < mesh.faceStarts[f + 1]; ++c) {
                const glm::vec3 normal = mesh.normals[mesh.cornerNormals[c]];
                QVERIFY(std::abs(glm::length(normal) - 1.0f) < 1e-6f);
                QVERIFY(isCoarse || glm::dot(normal, faceNormal(mesh, f)) > 0.95f);
                low = glm::min(low, mesh.texcoords[mesh.cornerTexcoords[c]]);
                high = glm::max(high, mesh.texcoords[mesh.cornerTexcoords[c]]);
            }
            QVERIFY(low.x >= 0.0f && low.y >= 0.0f && high.x <= 1.0f && high.y <= 1.0f);
            // No face spans the picture backwards across a seam.
            QVERIFY(isCoarse || (high.x - low.x < 0.13f && high.y - low.y < 0.13f));
        }
    }

    /// Each triangle at a pole has the middle of its strip there, so that none of the picture is sheared.
    void polesLieInTheMiddleOfTheirStrips() {
        const MeshData sphere = makeLowPolySphere();
        int poles = 0;
        for (std::size_t f = 0; f < sphere.faceCount(); ++f) {
            if (sphere.face(f).size() != 3) {
                continue;
            }
            ++poles;
            glm::vec2 pole(0.0f);
            float others = 0.0f;
            for (std::size_t c = sphere.faceStarts[f]; c < sphere.faceStarts[f + 1]; ++c) {
                const glm::vec2 texcoord = sphere.texcoords[sphere.cornerTexcoords[c]];
                const bool isPole = texcoord.y == 0.0f || texcoord.y == 1.0f;
                pole = isPole ? texcoord : pole;
                others += isPole ? 0.0f : 0.5f * texcoord.x;
            }
            QVERIFY(std::abs(pole.x - others) < 1e-6f);
        }
        QCOMPARE(poles, 40);
    }

    void cubesHaveExactFaces() {
        const MeshData cube = makeHighPolyCube(2.5f);
        QCOMPARE(cube.normals.size(), std::size_t{6});
        QVERIFY(cube.bounds().min == glm::vec3(-2.5f) && cube.bounds().max == glm::vec3(2.5f));
        for (std::size_t f = 0; f < cube.faceCount(); ++f) {
            const glm::vec3 normal = cube.normals[cube.cornerNormals[cube.faceStarts[f]]];
            for (const std::uint32_t vertex : cube.face(f)) {
                QCOMPARE(glm::dot(cube.positions[vertex], normal), 2.5f);
            }
        }
    }

    void spheresAreRound() {
        for (const MeshData& sphere : {makeLowPolySphere(2.5f), makeHighPolySphere(2.5f)}) {
            for (std::size_t v = 0; v < sphere.vertexCount(); ++v) {
                QVERIFY(std::abs(glm::length(sphere.positions[v]) - 2.5f) < 1e-6f);
                QVERIFY(glm::distance(sphere.positions[v] / 2.5f, sphere.normals[v]) < 1e-6f);
            }
        }
        // 20 rings and 20 segments: the second vertex is 9 degrees from the pole.
        const MeshData sphere = makeLowPolySphere(2.0f);
        QVERIFY(sphere.positions.front() == glm::vec3(0.0f, 2.0f, 0.0f));
        QVERIFY(sphere.positions.back() == glm::vec3(0.0f, -2.0f, 0.0f));
        QVERIFY(std::abs(sphere.positions[1].y - 2.0f * std::cos(glm::radians(9.0f))) < 1e-6f);
        QCOMPARE(statisticsOf(sphere).triangles, std::size_t{40});
    }

    void splittingMakesOnlyQuads() {
        const MeshData once = splitIntoQuadsOnSphere(makeUvSphere(32, 16, 1.0f), 1.0f);
        QCOMPARE(once.vertexCount(), std::size_t{482 + 992 + 512});
        const SurfaceStatistics topology = statisticsOf(once);
        QCOMPARE(topology.quads, topology.faces);
        QCOMPARE(topology.faces, std::size_t{448 * 4 + 64 * 3});
    }
};

HITSCOPE_TEST(PrimitivesTest, QCoreApplication)

}  // namespace hitscope::mesh_primitives_test

#include "mesh_primitives_test.moc"
