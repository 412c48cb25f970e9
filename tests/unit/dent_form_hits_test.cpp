// SPDX-License-Identifier: GPL-3.0-or-later
// The forms of dents: what holds for all hits.
#include <QTest>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/vector_relational.hpp>
#include <initializer_list>

#include "deform/dent_form_text.h"
#include "deform/fingerprint.h"
#include "deform/hit_bounds.h"
#include "deform/reference.h"
#include "deform_support.h"
#include "dent_form_support.h"
#include "mesh/geodesic_sphere.h"
#include "support/test_program.h"

namespace hitscope::dent_form_hits_test {

using namespace test;

namespace {

bool isWithin(const glm::vec3& point, const Bounds& box) {
    return glm::all(glm::lessThanEqual(box.min, point)) && glm::all(glm::lessThanEqual(point, box.max));
}

/// After all of these hits.
std::vector<DynamicVertex> deformed(const RenderMesh& mesh,
                                    std::initializer_list<std::span<const Hit>> parts) {
    std::vector<DynamicVertex> vertices(mesh.vertices.begin(), mesh.vertices.end());
    for (const std::span<const Hit> part : parts) {
        for (const Hit& hit : part) {
            for (DynamicVertex& vertex : vertices) {
                deform(vertex.position, vertex.normal, hit);
            }
        }
    }
    return vertices;
}

std::vector<Hit> anyHits(std::mt19937& random, std::size_t count) {
    std::vector<Hit> hits;
    for (std::size_t i = 0; i < count; ++i) {
        hits.push_back(anyHit(random, random() % 7));
    }
    return hits;
}

}  // namespace

class DentFormHitsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void reachHoldsWhatMoves();
    void boxesHoldWhatIsMoved();
    void movedBoxesHoldBeforeAndAfter();
    void whatMovedLastIsKnown();
    void editsChangeNothingElsewhere();
    void referenceEqualsThePlainLoop();
    void contributionIsWhatDeformAdds();
};

void DentFormHitsTest::reachHoldsWhatMoves() {
    std::mt19937 random(5);
    for (std::size_t i = 0; i < 700; ++i) {
        const Hit hit = anyHit(random, i);
        const HitReach reach = reachOf(hit);
        for (int k = 0; k < 200; ++k) {
            const glm::vec3 point = hit.point + test::randomPoint(random, 1.0f);
            const std::optional<Contribution> made = contributionTo(point, hit);
            if (made) {
                QVERIFY(glm::distance(point, reach.centre) <= reach.radius * 1.00001f);
                QVERIFY(std::abs(made->magnitude) <= farthestPush(hit) * 1.00001f);
            }
        }
    }
}

/// Each hit alone, on clusters whose boxes are as tight as they can be.
void DentFormHitsTest::boxesHoldWhatIsMoved() {
    const RenderMesh mesh = buildRenderMesh(makeGeodesicSphere(20, 1.0f));
    std::mt19937 random(9);
    for (std::size_t i = 0; i < 350; ++i) {
        const Hit hit = anyHit(random, i);
        ClusterReach reach(mesh.clusters);
        std::vector<std::uint32_t> reached;
        reach.advance(hit, reached);
        for (std::uint32_t c = 0; c < mesh.clusters.size(); ++c) {
            const Bounds box = reach.bounds(std::size_t{c});
            for (std::uint32_t k = 0; k < mesh.clusters[c].count; ++k) {
                DynamicVertex vertex = mesh.vertices[mesh.clusters[c].first + k];
                deform(vertex.position, vertex.normal, hit);
                for (glm::length_t axis = 0; axis < 3; ++axis) {
                    QVERIFY2(vertex.position[axis] >= box.min[axis] && vertex.position[axis] <= box.max[axis],
                             qPrintable(QString::number(i % 7)));
                }
            }
        }
    }
}

void DentFormHitsTest::movedBoxesHoldBeforeAndAfter() {
    const RenderMesh mesh = buildRenderMesh(makeGeodesicSphere(12, 1.0f));
    std::mt19937 random(3);
    ClusterReach reach(mesh.clusters);
    std::vector<DynamicVertex> vertices(mesh.vertices.begin(), mesh.vertices.end());
    for (std::size_t i = 0; i < 200; ++i) {
        const Hit hit = anyHit(random, i);
        const std::uint64_t moment = reach.moment();
        std::vector<std::uint32_t> reached;
        reach.advance(hit, reached);
        const auto moved = reach.movedSince(moment);
        QVERIFY(moved.has_value());
        for (DynamicVertex& vertex : vertices) {
            const glm::vec3 before = vertex.position;
            deform(vertex.position, vertex.normal, hit);
            QVERIFY(vertex.position == before ||
                    std::any_of(moved->begin(), moved->end(), [&](const Bounds& box) {
                        return isWithin(before, box) && isWithin(vertex.position, box);
                    }));
        }
    }
}

/// However much has moved before.
void DentFormHitsTest::whatMovedLastIsKnown() {
    constexpr std::size_t kEnough = 2000;  // boxes
    const RenderMesh mesh = buildRenderMesh(makeGeodesicSphere(12, 1.0f));
    std::mt19937 random(7);
    ClusterReach reach(mesh.clusters);
    struct Step {
        std::uint64_t moment;
        std::size_t before;  // boxes
    };
    std::vector<Step> steps;
    std::size_t boxes = 0;
    while (boxes < 5 * kEnough) {
        steps.push_back({reach.moment(), boxes});
        std::vector<std::uint32_t> reached;
        reach.advance(anyHit(random, steps.size()), reached);
        const auto moved = reach.movedSince(steps.back().moment);
        QVERIFY(moved.has_value());
        boxes += moved->size();
        for (const Step& step : steps) {
            const std::size_t since = boxes - step.before;
            if (since <= kEnough) {
                QVERIFY(reach.movedSince(step.moment).has_value());
                QCOMPARE(reach.movedSince(step.moment)->size(), since);
            }
        }
    }
    QVERIFY(!reach.movedSince(steps.front().moment));
}

/// Wherever in a history hits are taken out or put in.
void DentFormHitsTest::editsChangeNothingElsewhere() {
    const RenderMesh mesh = buildRenderMesh(makeGeodesicSphere(12, 1.0f));
    std::mt19937 random(23);
    std::size_t changed = 0;
    std::size_t outside = 0;
    for (std::size_t i = 0; i < 150; ++i) {
        const std::vector<Hit> first = anyHits(random, i % 4);
        const std::vector<Hit> before = anyHits(random, i % 3);
        const std::vector<Hit> after = anyHits(random, i % 3 == 0 ? 1 : i % 2);
        const std::vector<Hit> later = anyHits(random, i % 5);
        const auto box = changedBy(before, after, later);
        QVERIFY(box.has_value());
        const std::vector<DynamicVertex> was = deformed(mesh, {first, before, later});
        const std::vector<DynamicVertex> is = deformed(mesh, {first, after, later});
        for (std::size_t v = 0; v < was.size(); ++v) {
            if (was[v].position != is[v].position) {
                ++changed;
                QVERIFY(isWithin(was[v].position, *box) && isWithin(is[v].position, *box));
            } else if (!isWithin(is[v].position, *box)) {
                ++outside;
            }
        }
    }
    QVERIFY2(changed > 1000 && outside > 10'000,
             qPrintable(QStringLiteral("%1 %2").arg(changed).arg(outside)));
    QVERIFY(!changedBy(anyHits(random, 2000), {}, {}).has_value());
}

/// So that no cluster is left out that a hit of any form reaches or pushes there.
void DentFormHitsTest::referenceEqualsThePlainLoop() {
    const RenderMesh mesh = buildRenderMesh(makeGeodesicSphere(40, 1.0f));
    std::mt19937 random(7);
    std::vector<Hit> hits;
    for (std::size_t i = 0; i < 400; ++i) {
        hits.push_back(anyHit(random, i));
    }
    PageVector<DynamicVertex> expected = mesh.vertices;
    deformEverywhere(expected, hits);
    ReferenceDeformation reference(mesh);
    reference.apply(hits);
    const std::span<const DynamicVertex> vertices = reference.vertices();
    QCOMPARE(vertices.size(), expected.size());
    QCOMPARE(std::memcmp(vertices.data(), expected.data(), vertices.size_bytes()), 0);
    // One after the other with nothing seen between: boxes only grow.
    ClusterReach reach(mesh.clusters);
    PageVector<DynamicVertex> pushed = mesh.vertices;
    for (const Hit& hit : hits) {
        std::vector<std::uint32_t> reached;
        reach.advance(hit, reached);
        for (std::uint32_t c = 0; c < mesh.clusters.size(); ++c) {
            bool moved = false;
            for (std::uint32_t i = 0; i < mesh.clusters[c].count; ++i) {
                DynamicVertex& vertex = pushed[mesh.clusters[c].first + i];
                moved = deform(vertex.position, vertex.normal, hit) || moved;
            }
            QVERIFY(!moved || std::binary_search(reached.begin(), reached.end(), c));
        }
    }
}

void DentFormHitsTest::contributionIsWhatDeformAdds() {
    std::mt19937 random(11);
    for (std::size_t i = 0; i < 20'000; ++i) {
        const Hit hit = anyHit(random, i);
        const glm::vec3 at = hit.point + test::randomPoint(random, 0.4f);
        glm::vec3 position = at;
        glm::vec3 normal(0.0f, 0.0f, 1.0f);
        const bool isMoved = deform(position, normal, hit);
        const std::optional<Contribution> made = contributionTo(at, hit);
        QCOMPARE(made.has_value(), isMoved);
        QCOMPARE(position, isMoved ? at + made->displacement : at);
    }
}

HITSCOPE_TEST(DentFormHitsTest, QCoreApplication)

}  // namespace hitscope::dent_form_hits_test

#include "dent_form_hits_test.moc"
