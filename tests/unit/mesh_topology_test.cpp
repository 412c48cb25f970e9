// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "mesh/primitives.h"
#include "mesh/topology.h"
#include "mesh_support.h"
#include "support/test_program.h"

using namespace hitscope;
using hitscope::test::meshOf;

namespace {

/// The wall of a cylinder, n quads around; with lids: two n-gons.
MeshData cylinder(std::uint32_t n, bool hasLids) {
    std::vector<glm::vec3> positions;
    std::vector<std::vector<std::uint32_t>> faces;
    std::vector<std::uint32_t> top;
    std::vector<std::uint32_t> bottom;
    for (std::uint32_t i = 0; i < n; ++i) {
        const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(n);
        positions.emplace_back(std::cos(angle), std::sin(angle), 0.0f);
        positions.emplace_back(std::cos(angle), std::sin(angle), 1.0f);
        const std::uint32_t next = (i + 1) % n;
        faces.push_back({2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
        top.push_back(2 * i + 1);
        bottom.push_back(2 * (n - 1 - i));
    }
    if (hasLids) {
        faces.push_back(top);
        faces.push_back(bottom);
    }
    return meshOf(positions, faces);
}

/// Triangles around one vertex.
MeshData fan(std::uint32_t sides, bool isShuffled) {
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::uint32_t i = 0; i < sides; ++i) {
        faces.push_back({0, 1 + i, 1 + (i + 1) % sides});
    }
    if (isShuffled) {
        std::shuffle(faces.begin(), faces.end(), std::mt19937(3));
    }
    return meshOf(std::vector<glm::vec3>(sides + 1), faces);
}

GeometryStatistics geometryOf(const MeshData& mesh) {
    return computeGeometry(mesh, mesh.positions, computeTopology(mesh));
}

}  // namespace

class TopologyTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void cube() {
        const TopologyStatistics t = computeTopology(makeCube(4, 1.0f));
        QCOMPARE(t.vertices, std::size_t{98});
        QCOMPARE(t.edges, std::size_t{192});
        QCOMPARE(t.faces, std::size_t{96});
        QCOMPARE(t.quads, std::size_t{96});
        QCOMPARE(t.eulerCharacteristic.value_or(0), 2LL);
        QVERIFY(t.watertight);
    }

    void openCylinder() {
        const TopologyStatistics t = computeTopology(cylinder(12, false));
        QCOMPARE(t.boundaryEdges, std::size_t{24});
        QCOMPARE(t.edges, std::size_t{36});
        QCOMPARE(t.eulerCharacteristic.value_or(9), 0LL);
        QCOMPARE(t.components, std::size_t{1});
        QVERIFY(!t.watertight);
        QVERIFY(!geometryOf(cylinder(12, false)).volume);
    }

    void closedCylinder() {
        const TopologyStatistics t = computeTopology(cylinder(12, true));
        QCOMPARE(t.largerPolygons, std::size_t{2});
        QVERIFY(t.watertight);
        QCOMPARE(t.eulerCharacteristic.value_or(9), 2LL);
        const GeometryStatistics g = geometryOf(cylinder(1000, true));
        QVERIFY(std::abs(g.volume.value_or(0.0) - std::numbers::pi) < 1e-4);
        QVERIFY(std::abs(g.surfaceArea - 4.0 * std::numbers::pi) < 1e-4);
    }

    void twoComponentsAndALooseVertex() {
        const TopologyStatistics t = computeTopology(
            meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {9, 9, 9}},
                   {{0, 1, 2}, {3, 4, 5}}));
        QCOMPARE(t.components, std::size_t{2});
        QCOMPARE(t.unreferencedVertices, std::size_t{1});
        QCOMPARE(t.boundaryEdges, std::size_t{6});
        QCOMPARE(t.eulerCharacteristic.value_or(0), 2LL);  // the loose vertex is no part of the surface
    }

    void facesThatMeetInAPointAreTwoComponents() {
        const TopologyStatistics t = computeTopology(
            meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}));
        QCOMPARE(t.components, std::size_t{2});
        QCOMPARE(t.nonManifoldFaces, std::size_t{0});
    }

    void aThirdFaceOnAnEdgeIsNotManifold() {
        const TopologyStatistics t = computeTopology(meshOf(
            {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}));
        QCOMPARE(t.nonManifoldFaces, std::size_t{1});
        QCOMPARE(t.edges, std::size_t{7});
        QVERIFY(!t.eulerCharacteristic);
        QVERIFY(!t.watertight);
    }

    void aFaceTurnedOverIsNotManifold() {
        const TopologyStatistics t =
            computeTopology(meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 1, 3}}));
        QCOMPARE(t.nonManifoldFaces, std::size_t{1});
    }

    void aFaceThatRepeatsAVertexIsDegenerate() {
        const TopologyStatistics t = computeTopology(meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
                                                            {{0, 1, 2}, {1, 1, 2}, {1, 3, 2, 3}, {0, 0, 0}}));
        QCOMPARE(t.degenerateFaces, std::size_t{3});
        QCOMPARE(t.nonManifoldFaces, std::size_t{0});
        QCOMPARE(t.components, std::size_t{1});
        QVERIFY(!t.eulerCharacteristic);
    }

    void noFaces() {
        const TopologyStatistics t = computeTopology(meshOf({{0, 0, 0}}, {}));
        QCOMPARE(t.components, std::size_t{0});
        QVERIFY(!t.watertight);
        QCOMPARE(computeTopology(MeshData()).vertices, std::size_t{0});
    }

    /// OpenMesh is built with assertions: what it cannot hold must not reach it.
    void soupsDoNotStopTheProgram() {
        std::mt19937 random(7);
        for (int round = 0; round < 300; ++round) {
            const auto vertices = static_cast<std::uint32_t>(4 + round % 40);
            std::uniform_int_distribution<std::uint32_t> vertex(0, vertices - 1);
            std::vector<std::vector<std::uint32_t>> faces;
            for (int f = 0; f < 150; ++f) {
                std::vector<std::uint32_t> face(3 + random() % 4);
                std::generate(face.begin(), face.end(), [&] { return vertex(random); });
                faces.push_back(face);
                if (f % 10 == 0) {
                    faces.push_back(face);  // twice, and turned over
                    std::reverse(face.begin(), face.end());
                    faces.push_back(face);
                }
            }
            const MeshData mesh = meshOf(std::vector<glm::vec3>(vertices), faces);
            const TopologyStatistics t = computeTopology(mesh);
            QVERIFY(t.degenerateFaces + t.nonManifoldFaces < t.faces);
        }
    }

    void largeFansInOrderAreConnected() {
        QCOMPARE(computeTopology(fan(100000, false)).nonManifoldFaces, std::size_t{0});
        QVERIFY(computeTopology(fan(3000, true)).eulerCharacteristic == 1);
    }

    /// In no order they would take OpenMesh minutes: what is too much is left out, and said.
    void largeFansInNoOrderEnd() {
        const TopologyStatistics t = computeTopology(fan(100000, true));
        QVERIFY(t.nonManifoldFaces > 0 && t.nonManifoldFaces < 100000);
        QVERIFY(!t.eulerCharacteristic);
        QCOMPARE(t.edges, std::size_t{200000});
    }

    void cubeMeasures() {
        const GeometryStatistics g = geometryOf(makeCube(8, 2.5f));
        QVERIFY(std::abs(g.surfaceArea - 150.0) < 1e-9);
        QVERIFY(std::abs(g.volume.value_or(0.0) - 125.0) < 1e-9);
        QVERIFY(g.bounds.max == glm::vec3(2.5f));
    }

    void measuresFollowThePositions() {
        const MeshData mesh = makeCube(2, 1.0f);
        std::vector<glm::vec3> moved = mesh.positions;
        for (glm::vec3& position : moved) {
            position = position * glm::vec3(1.0f, 2.0f, 1.0f) + glm::vec3(1000.0f, 0.0f, 0.0f);
        }
        const GeometryStatistics g = computeGeometry(mesh, moved, computeTopology(mesh));
        QVERIFY(std::abs(g.volume.value_or(0.0) - 16.0) < 1e-6);
        QVERIFY(std::abs(g.surfaceArea - 40.0) < 1e-6);
    }

    void sphereMeasuresApproachTheClosedForm() {
        const GeometryStatistics g = geometryOf(makeHighPolySphere(1.0f));
        QVERIFY(std::abs(g.surfaceArea - 4.0 * std::numbers::pi) < 0.02);
        QVERIFY(std::abs(g.volume.value_or(0.0) - 4.0 / 3.0 * std::numbers::pi) < 0.01);
        QVERIFY(g.surfaceArea < 4.0 * std::numbers::pi);
    }

    void insideOutHasTheSameVolume() {
        MeshData mesh = makeCube(1, 1.0f);
        for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
            std::reverse(mesh.cornerVertices.begin() + mesh.faceStarts[f],
                         mesh.cornerVertices.begin() + mesh.faceStarts[f + 1]);
        }
        QVERIFY(std::abs(geometryOf(mesh).volume.value_or(0.0) - 8.0) < 1e-9);
    }

    void concavePolygonsKeepTheirArea() {
        // An arrowhead whose fan about the first corner covers part of it twice.
        QCOMPARE(geometryOf(test::polygon({{0, 2}, {0, 0}, {-2, 0}, {0, -4}, {2, 0}})).surfaceArea, 10.0);
    }
};

HITSCOPE_TEST(TopologyTest, QCoreApplication)
#include "mesh_topology_test.moc"
