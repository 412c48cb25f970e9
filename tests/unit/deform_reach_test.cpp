// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <algorithm>
#include <cstring>

#include "deform/cluster_reach.h"
#include "deform/reference.h"
#include "deform_support.h"
#include "mesh/primitives.h"
#include "mesh/teapot.h"

using namespace hitscope;

Q_DECLARE_METATYPE(hitscope::MeshData)

namespace {

bool contains(std::span<const VertexRange> ranges, std::uint32_t vertex) {
    return std::any_of(ranges.begin(), ranges.end(), [vertex](const VertexRange& range) {
        return vertex >= range.first && vertex - range.first < range.count;
    });
}

std::uint32_t total(std::span<const VertexRange> ranges) {
    std::uint32_t sum = 0;
    for (const VertexRange& range : ranges) {
        sum += range.count;
    }
    return sum;
}

MeshData shifted(MeshData mesh, const glm::vec3& by) {
    for (glm::vec3& position : mesh.positions) {
        position += by;
    }
    return mesh;
}

/// Hits that pile on a few vertices of the surface and follow them wherever they are pushed.
std::vector<Hit> piledHits(const RenderMesh& mesh, std::size_t count) {
    std::mt19937 random(17);
    test::BruteForce pushed(mesh);
    std::vector<Hit> hits;
    for (std::size_t i = 0; i < count; ++i) {
        Hit hit = test::randomHit(random, 0.25f);
        const std::size_t spot = (i % 5) * mesh.vertices.size() / 5;
        hit.point += i % 2 == 0 ? pushed.vertices[spot].position : mesh.vertices[spot].position;
        if (i % 7 == 0) {
            hit.constants = {.maxDistance = 0.2f, .power = 1.0f, .maxMagnitude = 1.5f};
        }
        pushed.apply(hit);
        hits.push_back(hit);
    }
    return hits;
}

}  // namespace

class ReachTest : public QObject {
    Q_OBJECT

    static void addMeshes() {
        QTest::addColumn<MeshData>("mesh");
        QTest::newRow("LP cube") << makeLowPolyCube();
        QTest::newRow("HP sphere") << makeHighPolySphere();
        QTest::newRow("teapot") << makeTeapot(8);
        QTest::newRow("far from the origin") << shifted(makeLowPolySphere(), {20000.0f, -7000.0f, 300.0f});
    }

private Q_SLOTS:
    void rangesAreMerged() {
        QCOMPARE(merged({}), (std::vector<VertexRange>{}));
        QCOMPARE(merged({{10, 5}, {0, 5}}), (std::vector<VertexRange>{{0, 5}, {10, 5}}));
        QCOMPARE(merged({{5, 5}, {0, 5}}), (std::vector<VertexRange>{{0, 10}}));
        QCOMPARE(merged({{0, 10}, {2, 3}, {8, 4}, {20, 0}}), (std::vector<VertexRange>{{0, 12}}));
    }

    void noVertexIsMissed_data() { addMeshes(); }
    void noVertexIsMissed() {
        QFETCH(MeshData, mesh);
        const RenderMesh render = buildRenderMesh(mesh);
        ClusterReach reach(render.clusters);
        test::BruteForce bruteForce(render);
        std::size_t reached = 0;
        for (const Hit& hit : piledHits(render, 2000)) {
            const std::vector<VertexRange> ranges = reach.advance(hit);
            for (const std::uint32_t vertex : bruteForce.apply(hit)) {
                ++reached;
                QVERIFY(contains(ranges, vertex));
            }
        }
        QVERIFY(reached > 1000);
    }

    void theReferenceIsThePlainLoop_data() { addMeshes(); }
    void theReferenceIsThePlainLoop() {
        QFETCH(MeshData, mesh);
        const RenderMesh render = buildRenderMesh(mesh);
        ReferenceDeformation reference(render);
        test::BruteForce bruteForce(render);
        const std::vector<Hit> hits = piledHits(render, 500);
        for (std::size_t first = 0; first < hits.size(); first += 10) {
            const std::vector<DynamicVertex> before(reference.vertices().begin(), reference.vertices().end());
            const std::vector<VertexRange> changed = reference.apply(std::span(hits).subspan(first, 10));
            for (std::size_t i = first; i < first + 10; ++i) {
                bruteForce.apply(hits[i]);
            }
            for (std::uint32_t v = 0; v < before.size(); ++v) {
                const bool isSame =
                    std::memcmp(&before[v], &reference.vertices()[v], sizeof(DynamicVertex)) == 0;
                QVERIFY(isSame || contains(changed, v));
            }
        }
        QCOMPARE(std::memcmp(reference.vertices().data(), bruteForce.vertices.data(),
                             bruteForce.vertices.size() * sizeof(DynamicVertex)),
                 0);
    }

    /// Render vertices of one file vertex lie in different clusters; the surface must not open between them.
    void seamsStayClosed() {
        const MeshData mesh = makeHighPolyCube();
        const RenderMesh render = buildRenderMesh(mesh);
        ReferenceDeformation reference(render);
        reference.apply(piledHits(render, 1000));
        for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
            const auto members = render.renderVerticesOf(v);
            for (const std::uint32_t member : members) {
                QVERIFY(reference.vertices()[member].position ==
                        reference.vertices()[members.front()].position);
            }
        }
    }

    /// The work of a hit follows the hit, however many came before it, here or elsewhere.
    void hitsInOnePlaceStayLocal() {
        const RenderMesh render = buildRenderMesh(makeHighPolySphere(2.5f));
        ClusterReach reach(render.clusters);
        Hit hit;
        hit.point = {0.0f, 2.5f, 0.0f};
        hit.direction = {0.0f, -1.0f, 0.0f};
        const std::uint32_t first = total(reach.advance(hit));
        for (int i = 0; i < 5000; ++i) {
            (void)reach.advance(hit);
        }
        QVERIFY(first > 0 && first < render.vertices.size() / 4);
        QVERIFY(total(reach.advance(hit)) <= 2 * first);

        Hit below = hit;
        below.point = -hit.point;
        QCOMPARE(reach.advance(below), ClusterReach(render.clusters).advance(below));
    }

    /// A vertex that float's rounding puts within reach is found, though exactly measured it is not.
    void roundingAtTheRimIsCovered() {
        std::mt19937 random(23);
        std::uniform_real_distribution<float> nearOne(1.0f - 2e-7f, 1.0f + 2e-7f);
        int beyond = 0;
        for (int i = 0; i < 20000; ++i) {
            DynamicVertex vertex{test::randomPoint(random, i % 2 == 0 ? 1.0f : 1000.0f), {0.0f, 1.0f, 0.0f}};
            const Cluster cluster{0, 1, {vertex.position, 0.0f}};
            ClusterReach reach(std::span(&cluster, 1));
            for (int step = 0; step < 4; ++step) {
                Hit hit = test::randomHit(random, 1.0f);
                const float distance = hit.constants.maxDistance * nearOne(random);
                hit.point = vertex.position + glm::normalize(hit.point) * distance;
                const double exactly = glm::distance(glm::dvec3(hit.point), glm::dvec3(vertex.position));
                const bool isFound = !reach.advance(hit).empty();
                const bool isReached = deform(vertex.position, vertex.normal, hit);
                QVERIFY(isFound || !isReached);
                beyond += isReached && exactly > 0.5 ? 1 : 0;
            }
        }
        QVERIFY(beyond > 100);
    }

    void whatLiesOutOfReachIsNotTouched() {
        const RenderMesh render = buildRenderMesh(makeLowPolySphere());
        ClusterReach reach(render.clusters);
        Hit hit;
        hit.point = {50.0f, 0.0f, 0.0f};
        QVERIFY(reach.advance(hit).empty());
        ClusterReach nothing(std::span<const Cluster>{});
        QVERIFY(nothing.advance(hit).empty());
    }
};

QTEST_APPLESS_MAIN(ReachTest)
#include "deform_reach_test.moc"
