// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <bit>
#include <cstring>
#include <random>
#include <set>

#include "deform/cluster_reach.h"
#include "deform/reference.h"
#include "deform_support.h"
#include "mesh/primitives.h"
#include "mesh/teapot.h"
#include "support/test_program.h"

namespace hitscope::deform_reach_test {

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

std::vector<VertexRange> advance(ClusterReach& reach, const Hit& hit) {
    std::vector<std::uint32_t> clusters;
    reach.advance(hit, clusters);
    return reach.rangesOf(clusters);
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
        QTest::newRow("Low-poly cube") << makeLowPolyCube();
        QTest::newRow("High-poly sphere") << makeHighPolySphere();
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
            const std::vector<VertexRange> ranges = advance(reach, hit);
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

    /// As noVertexIsMissed, with looks at where the vertices are now and then, some of them out of date.
    void noVertexIsMissedByTightBoxes() {
        const RenderMesh render = buildRenderMesh(makeHighPolySphere());
        ClusterReach reach(render.clusters);
        test::BruteForce bruteForce(render);
        const std::vector<Hit> hits = piledHits(render, 2000);
        PageVector<DynamicVertex> seen = render.vertices;
        std::size_t seenHits = 0;
        for (std::size_t i = 0; i < hits.size(); ++i) {
            const std::vector<VertexRange> ranges = advance(reach, hits[i]);
            for (const std::uint32_t vertex : bruteForce.apply(hits[i])) {
                QVERIFY(contains(ranges, vertex));
            }
            if (i % 10 == 5) {
                seen.assign(bruteForce.vertices.begin(), bruteForce.vertices.end());
                seenHits = i + 1;
            }
            if (i % 10 == 9) {
                reach.place(100, std::span(seen).subspan(100, 5000),
                            std::span(hits).subspan(seenHits, i + 1 - seenHits));
            }
        }
    }

    /// Whatever a hit in the past has reached, or one put in there would, is found afterwards.
    void everReachedKnowsThePast() {
        const RenderMesh render = buildRenderMesh(makeLowPolySphere());
        ClusterReach reach(render.clusters);
        test::BruteForce bruteForce(render);
        const std::vector<Hit> hits = piledHits(render, 300);
        std::mt19937 random(29);
        std::vector<std::pair<Hit, std::vector<std::uint32_t>>> past;
        for (const Hit& hit : hits) {
            const Hit other = test::randomHit(random, 3.0f);
            test::BruteForce copy = bruteForce;
            past.emplace_back(other, copy.apply(other));
            past.emplace_back(hit, bruteForce.apply(hit));
            static_cast<void>(advance(reach, hit));
            reach.place(0, bruteForce.vertices);
        }
        for (const auto& [hit, vertices] : past) {
            std::vector<std::uint32_t> clusters;
            reach.everReached(hit, clusters);
            QVERIFY(clusters.empty() || reach.mayEverReach(hit));
            for (const std::uint32_t vertex : vertices) {
                QVERIFY(contains(reach.rangesOf(clusters), vertex));
            }
        }
    }

    void manyReachWhatEachReaches_data() {
        QTest::addColumn<int>("hits");
        for (const int hits : {0, 4, 400}) {
            QTest::addRow("%d hits", hits) << hits;
        }
    }
    void manyReachWhatEachReaches() {
        QFETCH(int, hits);
        const RenderMesh render = buildRenderMesh(makeLowPolySphere());
        ClusterReach reach(render.clusters);
        test::BruteForce bruteForce(render);
        for (const Hit& hit : piledHits(render, 40)) {
            static_cast<void>(advance(reach, hit));
            bruteForce.apply(hit);
            reach.place(0, bruteForce.vertices);
        }
        std::mt19937 random(31);
        std::vector<Hit> many;
        std::set<std::uint32_t> each;
        for (int i = 0; i < hits; ++i) {
            many.push_back(test::randomHit(random, 3.0f));
            std::vector<std::uint32_t> one;
            reach.everReached(many.back(), one);
            each.insert(one.begin(), one.end());
        }
        const std::vector<std::uint32_t> expected(each.begin(), each.end());
        const std::size_t half = many.size() / 2;
        QCOMPARE(reach.everReached(many), expected);
        QCOMPARE(reach.everReached(std::span(many).first(half), std::span(many).subspan(half)), expected);
        QCOMPARE(expected.empty(), hits == 0);
        QCOMPARE(expected.size() == render.clusters.size(), hits == 400);
    }

    void boxesFollowWhereVerticesAre() {
        const RenderMesh render = buildRenderMesh(makeLowPolyCube());
        ClusterReach reach(render.clusters);
        PageVector<DynamicVertex> away = render.vertices;
        for (DynamicVertex& vertex : away) {
            vertex.position.x += 30.0f;
        }
        Hit here;
        here.point = render.vertices[0].position;
        Hit there = here;
        there.point.x += 30.0f;
        QVERIFY(!advance(reach, here).empty());
        QVERIFY(advance(reach, there).empty());
        reach.place(0, away);
        QVERIFY(advance(reach, here).empty());
        QVERIFY(!advance(reach, there).empty());
        reach.goBack(reach.clustersIn({{{0, static_cast<std::uint32_t>(away.size())}}}));
        QVERIFY(!advance(reach, here).empty());
        reach.restart();
        QVERIFY(advance(reach, there).empty());
        std::vector<std::uint32_t> ever;
        reach.everReached(there, ever);
        QVERIFY(ever.empty());
    }

    /// Whether few or many clusters changed, and by which way.
    void restartedIsAsNew_data() {
        QTest::addColumn<int>("hits");
        QTest::newRow("few clusters") << 3;
        QTest::newRow("many") << 1000;
    }
    void restartedIsAsNew() {
        QFETCH(int, hits);
        const RenderMesh render = buildRenderMesh(makeHighPolySphere(2.5f));
        const ClusterReach fresh(render);
        ClusterReach reach(render);
        std::mt19937 random(5);
        for (int round = 0; round < 3; ++round) {
            ReferenceDeformation reference(render);
            std::vector<std::uint32_t> reached;
            for (int i = 0; i < hits; ++i) {
                Hit hit = test::randomHit(random, 0.01f);
                hit.point += render.vertices[random() % render.vertices.size()].position;
                hit.constants = {.maxDistance = 0.3f, .power = 0.03f, .maxMagnitude = 0.1f};
                reach.advance(hit, reached);
                for (const VertexRange& range : reference.apply({&hit, 1})) {
                    reach.place(range.first, reference.vertices(range));
                }
            }
            QVERIFY(std::any_of(reached.begin(), reached.end(), [&](std::uint32_t cluster) {
                return reach.bounds(cluster).min != fresh.bounds(cluster).min ||
                       reach.bounds(cluster).max != fresh.bounds(cluster).max;
            }));
            reach.restart();
            for (std::size_t cluster = 0; cluster < render.clusters.size(); ++cluster) {
                QVERIFY(reach.isOriginal(cluster));
                QCOMPARE(reach.bounds(cluster).min, fresh.bounds(cluster).min);
                QCOMPARE(reach.bounds(cluster).max, fresh.bounds(cluster).max);
            }
            for (const std::size_t most : {1, 8, 1024}) {
                const std::vector<Bounds> groups = reach.boundsOfGroups(most);
                const std::vector<Bounds> freshGroups = fresh.boundsOfGroups(most);
                QCOMPARE(groups.size(), freshGroups.size());
                QVERIFY(std::memcmp(groups.data(), freshGroups.data(), groups.size() * sizeof(Bounds)) == 0);
            }
        }
    }

    /// Render vertices of one file vertex lie in different clusters; the surface must not open between them.
    void seamsStayClosed() {
        const MeshData mesh = makeHighPolyCube();
        const RenderMesh render = buildRenderMesh(mesh);
        QVERIFY(render.vertices.size() > mesh.vertexCount());  // there are seams
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
        const std::uint32_t first = total(advance(reach, hit));
        for (int i = 0; i < 5000; ++i) {
            (void)advance(reach, hit);
        }
        QVERIFY(first > 0 && first < render.vertices.size() / 4);
        QVERIFY(total(advance(reach, hit)) <= 2 * first);

        Hit below = hit;
        below.point = -hit.point;
        ClusterReach fresh(render.clusters);
        QCOMPARE(advance(reach, below), advance(fresh, below));
    }

    /// A vertex that float's rounding puts within reach is found, though exactly measured it is not.
    void roundingAtTheRimIsCovered() {
        std::mt19937 random(23);
        std::uniform_real_distribution<float> nearOne(1.0f - 2e-7f, 1.0f + 2e-7f);
        int beyond = 0;
        for (int i = 0; i < 20000; ++i) {
            DynamicVertex vertex{test::randomPoint(random, i % 2 == 0 ? 1.0f : 1000.0f), {0.0f, 1.0f, 0.0f}};
            const Cluster cluster{0, 1, {vertex.position, vertex.position}};
            ClusterReach reach(std::span(&cluster, 1));
            for (int step = 0; step < 4; ++step) {
                Hit hit = test::randomHit(random, 1.0f);
                const float distance = hit.constants.maxDistance * nearOne(random);
                hit.point = vertex.position + glm::normalize(hit.point) * distance;
                const double exactly = glm::distance(glm::dvec3(hit.point), glm::dvec3(vertex.position));
                const bool isFound = !advance(reach, hit).empty();
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
        QVERIFY(advance(reach, hit).empty());
        ClusterReach nothing(std::span<const Cluster>{});
        QVERIFY(advance(nothing, hit).empty());
    }

    void groupsHaveAllClusters() {
        const RenderMesh render = buildRenderMesh(makeTeapot());
        ClusterReach reach(render);
        Hit hit;
        hit.point = reach.clusters()[3].bounds.max;
        QVERIFY(!advance(reach, hit).empty());
        const std::size_t clusters = reach.clusters().size();
        QVERIFY(clusters > 9);
        for (const std::size_t most : {std::size_t{1}, std::size_t{9}, 2 * std::bit_ceil(clusters)}) {
            const std::vector<Bounds> groups = reach.boundsOfGroups(most);
            QVERIFY(groups.size() <= most);
            const std::size_t inOne = std::bit_ceil(clusters) / groups.size();
            for (std::size_t i = 0; i < clusters; ++i) {
                Bounds both = groups[i / inOne];
                both.add(reach.bounds(i));
                QVERIFY(both.min == groups[i / inOne].min && both.max == groups[i / inOne].max);
            }
        }
    }

    /// Of so many clusters the boxes are shared until they change, and each has its own changes.
    void oneTreeServesSeveral() {
        constexpr std::uint32_t kClusters = 40'000;
        std::vector<Cluster> clusters;
        for (std::uint32_t i = 0; i < kClusters; ++i) {
            const glm::vec3 at(static_cast<float>(i), 0.0f, 0.0f);
            clusters.push_back({i, 1, {at, at + glm::vec3(0.5f)}});
        }
        const std::shared_ptr<const ClusterTree> tree = clusterTreeOf(clusters);
        const ClusterTree before = *tree;
        ClusterReach one(clusters, tree);
        ClusterReach other(clusters, tree);
        Hit hit;
        hit.point = {30'000.2f, 0.2f, 0.2f};
        std::vector<std::uint32_t> reached;
        one.advance(hit, reached);
        QCOMPARE(reached, std::vector<std::uint32_t>{30'000});
        QVERIFY(!one.isOriginal(30'000) && one.bounds(30'000).max.x > clusters[30'000].bounds.max.x);
        QVERIFY(other.isOriginal(30'000) && other.bounds(30'000).max == clusters[30'000].bounds.max);
        QVERIFY(std::memcmp(before.data(), tree->data(), before.size() * sizeof(Bounds)) == 0);
        const std::uint64_t dented = one.moment();
        const Bounds where = one.bounds(30'000);
        one.restart();
        const auto moved = one.movedSince(dented);
        QVERIFY(moved && moved->size() == 1 && moved->front().max == where.max);
        QVERIFY(one.isOriginal(30'000) && one.bounds(30'000).max == clusters[30'000].bounds.max);
    }
};

HITSCOPE_TEST(ReachTest, QCoreApplication)

}  // namespace hitscope::deform_reach_test

#include "deform_reach_test.moc"
