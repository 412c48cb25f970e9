// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/surface_topology.h"

#include <QTest>
#include <algorithm>
#include <array>
#include <random>
#include <set>

#include "mesh/block_index.h"
#include "mesh/primitives.h"
#include "mesh/surface/connectivity.h"
#include "mesh/teapot.h"
#include "solids.h"
#include "support/test_program.h"

namespace hitscope::surface_topology_test {

using namespace test;

namespace {

SurfaceStatistics statisticsOf(const MeshData& mesh) {
    return SurfaceTopology::build(mesh)->statistics();
}

/// A strip of quads around the z axis with half a turn in it.
MeshData moebiusStrip(std::uint32_t quads) {
    PageVector<glm::vec3> positions;
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::uint32_t i = 0; i < quads; ++i) {
        const double u = 2.0 * std::numbers::pi * i / quads;
        for (const double side : {-0.3, 0.3}) {
            const double out = 1.0 + side * std::cos(u / 2.0);
            positions.emplace_back(out * std::cos(u), out * std::sin(u), side * std::sin(u / 2.0));
        }
        const bool isLast = i + 1 == quads;
        const std::uint32_t next = isLast ? 0 : 2 * i + 2;
        faces.push_back({2 * i, next + (isLast ? 1 : 0), next + (isLast ? 0 : 1), 2 * i + 1});
    }
    return meshOf(std::move(positions), faces);
}

MeshData withoutFace(const MeshData& mesh, std::size_t left) {
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        if (f != left) {
            faces.emplace_back(mesh.face(f).begin(), mesh.face(f).end());
        }
    }
    return meshOf(mesh.positions, faces);
}

}  // namespace

class SurfaceTopologyTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void cube() {
        const SurfaceStatistics s = statisticsOf(makeCube(4, 1.0f));
        QCOMPARE(s.vertices, std::size_t{98});
        QCOMPARE(s.places, std::size_t{98});
        QCOMPARE(s.edges, std::size_t{192});
        QCOMPARE(s.quads, std::size_t{96});
        QCOMPARE(s.eulerCharacteristic, 2LL);
        QCOMPARE(s.genus, std::optional<long long>(0));
        QCOMPARE(s.components, std::size_t{1});
        QVERIFY(s.watertight && s.isSolid());
    }

    void sphereAndTorusDifferByAHandle() {
        QCOMPARE(statisticsOf(makeHighPolySphere(1.0f)).genus, std::optional<long long>(0));
        const SurfaceStatistics s = statisticsOf(torus(24, 12, 2.0, 0.5));
        QCOMPARE(s.eulerCharacteristic, 0LL);
        QCOMPARE(s.genus, std::optional<long long>(1));
        QVERIFY(s.isSolid());
    }

    void openCylinderHasTwoHoles() {
        const SurfaceStatistics s = statisticsOf(cylinder(12, false));
        QCOMPARE(s.boundaryEdges, std::size_t{24});
        QCOMPARE(s.holes, std::size_t{2});
        QCOMPARE(s.edges, std::size_t{36});
        QCOMPARE(s.eulerCharacteristic, 0LL);
        QCOMPARE(s.genus, std::optional<long long>(0));
        QVERIFY(!s.watertight);
        const SurfaceStatistics closed = statisticsOf(cylinder(12, true));
        QCOMPARE(closed.holes, std::size_t{0});
        QCOMPARE(closed.largerPolygons, std::size_t{2});
        QVERIFY(closed.isSolid());
    }

    void twoComponentsAndALooseVertex() {
        MeshData both = together(makeCube(2, 1.0f), torus(8, 6, 5.0, 1.0));
        both.positions.emplace_back(9.0f);
        const SurfaceStatistics s = statisticsOf(both);
        QCOMPARE(s.components, std::size_t{2});
        QCOMPARE(s.unreferencedVertices, std::size_t{1});
        QCOMPARE(s.eulerCharacteristic, 2LL);
        QCOMPARE(s.genus, std::optional<long long>(1));
        QVERIFY(s.watertight);
    }

    void aFanOnOneEdgeIsNotManifold() {
        const SurfaceStatistics s = statisticsOf(nonManifoldFan(5));
        QCOMPARE(s.nonManifoldEdges, std::size_t{1});
        QCOMPARE(s.nonManifoldVertices, std::size_t{0});  // the edge's ends are told by the edge
        QCOMPARE(s.edges, std::size_t{11});
        QCOMPARE(s.boundaryEdges, std::size_t{10});
        QCOMPARE(s.components, std::size_t{1});
        QVERIFY(!s.genus && !s.watertight);
        QVERIFY(statisticsOf(nonManifoldFan(2)).isManifold());
    }

    void facesThatMeetInAPointAreNotManifoldThere() {
        const SurfaceStatistics s = statisticsOf(
            meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}));
        QCOMPARE(s.components, std::size_t{2});
        QCOMPARE(s.nonManifoldVertices, std::size_t{1});
        QCOMPARE(s.holes, std::size_t{2});  // two triangles' outlines, not one figure of eight
        QVERIFY(!s.genus);
    }

    void aFaceTurnedOverIsCounted() {
        MeshData cube = makeCube(2, 1.0f);
        turnOver(cube, 5);
        const SurfaceStatistics s = statisticsOf(cube);
        QCOMPARE(s.opposedEdges, std::size_t{4});
        QVERIFY(s.orientable && s.watertight && !s.isSolid());
        QCOMPARE(s.genus, std::optional<long long>(0));
    }

    void aMoebiusStripHasOneSide() {
        const SurfaceStatistics s = statisticsOf(moebiusStrip(16));
        QVERIFY(s.isManifold() && !s.orientable);
        QCOMPARE(s.holes, std::size_t{1});
        QCOMPARE(s.eulerCharacteristic, 0LL);
        QVERIFY(!s.genus);
    }

    void seamsAreWelded() {
        for (const MeshData& mesh : {makeCube(4, 1.0f), torus(24, 12, 2.0, 0.5), cylinder(12, false)}) {
            SurfaceStatistics whole = statisticsOf(mesh);
            SurfaceStatistics split = statisticsOf(exploded(mesh));
            QCOMPARE(split.vertices, mesh.cornerVertices.size());
            whole.vertices = split.vertices = 0;
            QVERIFY(whole == split);
        }
    }

    void cornersAtOnePlaceCollapse() {
        // A pole: the quad's upper side has no length, so it is a triangle of the surface.
        const SurfaceStatistics s =
            statisticsOf(meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}, {5, 5, 5}},
                                {{0, 1, 2, 3}, {0, 0, 1}, {0, 1, 0, 4}, {1, 1, 1}}));
        QCOMPARE(s.collapsedFaces, std::size_t{3});
        QCOMPARE(s.places, std::size_t{4});
        QCOMPARE(s.edges, std::size_t{3});
        QCOMPARE(s.components, std::size_t{1});
        QCOMPARE(s.eulerCharacteristic, 1LL);
    }

    /// Its way round goes over the bridge to the hole, along the hole, and back.
    void aPolygonWithAHoleIsARing() {
        const SurfaceStatistics s = statisticsOf(meshOf({{0, 0, 0},
                                                         {4, 0, 0},
                                                         {4, 4, 0},
                                                         {0, 4, 0},
                                                         {1, 1, 0},
                                                         {1, 3, 0},
                                                         {3, 3, 0},
                                                         {3, 1, 0},
                                                         {8, 0, 0},
                                                         {8, 4, 0}},
                                                        {{0, 1, 2, 3, 0, 4, 5, 6, 7, 4}, {1, 8, 9, 2}}));
        QCOMPARE(s.places, std::size_t{10});
        QCOMPARE(s.collapsedFaces, std::size_t{0});
        QCOMPARE(s.edges, std::size_t{12});
        QCOMPARE(s.boundaryEdges, std::size_t{10});
        QCOMPARE(s.components, std::size_t{1});
        QCOMPARE(s.holes, std::size_t{2});
        QCOMPARE(s.eulerCharacteristic, 0LL);
        QCOMPARE(s.genus, std::optional<long long>(0));
        QCOMPARE(s.opposedEdges, std::size_t{0});
        QVERIFY(s.isManifold());
    }

    void noFaces() {
        const SurfaceStatistics s = statisticsOf(meshOf({{0, 0, 0}}, {}));
        QCOMPARE(s.components, std::size_t{0});
        QVERIFY(!s.watertight && !s.genus);
        QCOMPARE(statisticsOf(MeshData()).vertices, std::size_t{0});
    }

    /// Against a look at every entry; the last run has fewer vertices, the last block fewer entries.
    void blocksOfVerticesAreFound() {
        constexpr std::uint32_t kVertices = 1000;
        std::mt19937 random(3);
        std::uniform_int_distribution<std::uint32_t> any(0, kVertices - 1);
        std::uniform_int_distribution<std::uint32_t> near(0, 39);
        std::vector<std::array<std::uint32_t, 3>> entries(5 * BlockIndex::kBlock + 7);
        for (std::array<std::uint32_t, 3>& entry : entries) {
            entry = {any(random), near(random), any(random)};
        }
        const BlockIndex index(kVertices, entries.size(), [&](std::size_t e) { return entries[e]; });
        std::vector<std::set<std::uint32_t>> expected(BlockIndex::runOf(kVertices - 1) + 1);
        for (std::size_t e = 0; e < entries.size(); ++e) {
            for (const std::uint32_t vertex : entries[e]) {
                expected[BlockIndex::runOf(vertex)].insert(
                    static_cast<std::uint32_t>(e / BlockIndex::kBlock));
            }
        }
        for (std::uint32_t run = 0; run < expected.size(); ++run) {
            const auto found = index.blocksOfRun(run);
            QVERIFY(std::equal(found.begin(), found.end(), expected[run].begin(), expected[run].end()));
        }
    }

    void stopsWhenAsked() {
        std::stop_source source;
        source.request_stop();
        QVERIFY(SurfaceTopology::build(makeCube(4, 1.0f), source.get_token()) == nullptr);
    }

    /// The other way to the same numbers: OpenMesh's half-edges, on surfaces with faces taken out at random.
    void agreesWithHalfEdges() {
        std::mt19937 random(5);
        int compared = 0;
        for (const MeshData& whole : {makeCube(6, 1.0f), torus(14, 9, 2.0, 0.5), makeTeapot(),
                                      makeHighPolySphere(1.0f), makeLowPolySphere(1.0f)}) {
            MeshData mesh = whole;
            for (int round = 0; round < 12; ++round) {
                const Connectivity other = hitscope::connect(mesh);
                const SurfaceStatistics s = statisticsOf(mesh);
                if (s.places + s.unreferencedVertices == s.vertices && other.refused == 0) {
                    QCOMPARE(s.edges, other.edges);
                    QCOMPARE(s.boundaryEdges, other.boundaryEdges);
                    QCOMPARE(s.components, other.components);
                    QCOMPARE(s.watertight, other.boundaryEdges == 0);
                    QCOMPARE(s.places, other.vertices);
                    QCOMPARE(s.faces - s.collapsedFaces, other.faces);
                    ++compared;
                }
                mesh = withoutFace(mesh, random() % mesh.faceCount());
            }
        }
        QVERIFY(compared > 40);
    }
};

HITSCOPE_TEST(SurfaceTopologyTest, QCoreApplication)

}  // namespace hitscope::surface_topology_test

#include "surface_topology_test.moc"
