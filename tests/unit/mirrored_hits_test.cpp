// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/mirrored_hits.h"

#include <QTest>
#include <glm/geometric.hpp>
#include <map>
#include <random>

#include "deform/reference.h"
#include "deform_support.h"
#include "mesh/primitives.h"
#include "support/test_program.h"

namespace hitscope::mirrored_hits_test {

namespace {

Plane across(int axis, float offset = 0.0f) {
    Plane plane{glm::vec3(0.0f), offset};
    plane.normal[axis] = 1.0f;
    return plane;
}

std::vector<Hit> randomHits(std::size_t count) {
    std::mt19937 random(5);
    std::vector<Hit> hits;
    for (std::size_t i = 0; i < count; ++i) {
        Hit hit = test::randomHit(random, 2.0f);
        hit.normal = -hit.direction;
        hit.triangle = 3;
        hit.group = {2, HitGroupKind::Stroke};
        hits.push_back(hit);
    }
    return hits;
}

}  // namespace

class MirroredHitsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void twiceIsTheSameAgain() {
        for (int axis = 0; axis < 3; ++axis) {
            for (const Hit& hit : randomHits(50)) {
                const Hit once = mirrored(hit, across(axis));
                QCOMPARE(once.point[axis], -hit.point[axis]);
                QCOMPARE(once.direction[axis], -hit.direction[axis]);
                QCOMPARE(once.normal[axis], -hit.normal[axis]);
                QCOMPARE(once.point[(axis + 1) % 3], hit.point[(axis + 1) % 3]);
                QCOMPARE(once.triangle, kNoIndex);
                QVERIFY(!once.group);
                Hit twice = mirrored(once, across(axis));
                twice.triangle = hit.triangle;
                twice.group = hit.group;
                QVERIFY(twice == hit);
            }
        }
    }

    /// Every vertex of a mesh that is symmetric in its bits: the mirrored hits make the mirror image.
    void aSymmetricMeshIsDentedSymmetricallyInEveryBit() {
        std::mt19937 random(9);
        std::uniform_real_distribution<float> any(-2.0f, 2.0f);
        std::vector<DynamicVertex> left;
        for (int i = 0; i < 3000; ++i) {
            const glm::vec3 at(any(random), any(random), any(random));
            left.push_back({at, glm::normalize(at)});
        }
        std::vector<DynamicVertex> right = left;
        for (DynamicVertex& vertex : right) {
            vertex.position.x = -vertex.position.x;
            vertex.normal.x = -vertex.normal.x;
        }
        const std::vector<Hit> hits = randomHits(300);
        deformEverywhere(left, hits);
        deformEverywhere(right, mirroredHits(hits, across(0)));
        std::size_t moved = 0;
        for (std::size_t i = 0; i < left.size(); ++i) {
            // Not QCOMPARE(), which lets floats differ a little.
            const DynamicVertex& image = right[i];
            QVERIFY(image.position == glm::vec3(-1.0f, 1.0f, 1.0f) * left[i].position);
            QVERIFY(image.normal == glm::vec3(-1.0f, 1.0f, 1.0f) * left[i].normal);
            moved += glm::length(left[i].position - glm::normalize(left[i].position)) > 0.0f ? 1 : 0;
        }
        QVERIFY(moved > 0);
    }

    void anyPlaneWillDo() {
        const glm::vec3 normal = glm::normalize(glm::vec3(1.0f, 2.0f, -0.5f));
        const Plane plane{normal, 0.75f};
        for (const Hit& hit : randomHits(50)) {
            const Hit image = mirrored(hit, plane);
            const glm::vec3 middle = 0.5f * (hit.point + image.point);
            QVERIFY(std::abs(glm::dot(middle, normal) - plane.offset) < 1e-5f);
            QVERIFY(std::abs(glm::length(glm::cross(hit.point - image.point, normal))) < 1e-4f);
            QVERIFY(std::abs(glm::length(image.direction) - 1.0f) < 1e-5f);
        }
        const Hit moved = mirrored(randomHits(1)[0], across(1, 0.5f));
        QCOMPARE(moved.point.y, 1.0f - randomHits(1)[0].point.y);
    }

    void aHitInThePlaneIsItsOwnImage() {
        Hit hit;
        hit.point = {0.0f, 1.0f, 0.0f};
        hit.direction = {0.0f, -1.0f, 0.0f};
        QVERIFY(mirroredHits({&hit, 1}, across(0)).empty());
        QCOMPARE(mirroredHits({&hit, 1}, across(1)).size(), std::size_t{1});
        hit.direction = glm::normalize(glm::vec3(0.5f, -1.0f, 0.0f));
        QCOMPARE(mirroredHits({&hit, 1}, across(0)).size(), std::size_t{1});
    }
};

HITSCOPE_TEST(MirroredHitsTest, QCoreApplication)

}  // namespace hitscope::mirrored_hits_test

#include "mirrored_hits_test.moc"
