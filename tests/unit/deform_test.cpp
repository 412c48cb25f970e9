// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/deform.h"

#include <QTest>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "deform_support.h"
#include "support/test_program.h"

namespace hitscope::deform_test {

namespace {

/// A hit at the origin straight down -z with constants that make the numbers round: power 0.5, reach 2,
/// cap 1.
Hit plainHit() {
    Hit hit;
    hit.constants = {.maxDistance = 2.0f, .power = 0.5f, .maxMagnitude = 1.0f};
    return hit;
}

/// The function once more, with every intermediate result forced into a float in memory: what the compiler
/// may neither contract nor reorder.
void deformRounded(glm::vec3& position, glm::vec3& normal, const Hit& hit) {
    const auto rounded = [](float value) {
        volatile float stored = value;
        return float(stored);
    };
    const auto dot = [&](float x, float y, float z) {
        return rounded(rounded(rounded(x * x) + rounded(y * y)) + rounded(z * z));
    };
    const float r2 = dot(rounded(position.x - hit.point.x), rounded(position.y - hit.point.y),
                         rounded(position.z - hit.point.z));
    if (r2 > rounded(hit.constants.maxDistance * hit.constants.maxDistance)) {
        return;
    }
    float m = hit.constants.maxMagnitude;
    if (r2 >= 1e-22f) {
        m = std::min(rounded(hit.constants.power / rounded(std::sqrt(r2))), m);
    }
    glm::vec3 sum;
    for (glm::length_t i = 0; i < 3; ++i) {
        const float v = rounded(hit.direction[i] * m);
        position[i] = rounded(position[i] + v);
        sum[i] = rounded(normal[i] + v);
    }
    const float len2 = dot(sum.x, sum.y, sum.z);
    if (len2 > 1e-12f) {
        for (glm::length_t i = 0; i < 3; ++i) {
            const float turned = rounded(sum[i] / rounded(std::sqrt(len2)));
            normal[i] = std::abs(sum[i]) < 1e-20f ? 0.0f : turned;
        }
    }
}

}  // namespace

class DeformTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void handWorked_data() {
        QTest::addColumn<glm::vec3>("position");
        QTest::addColumn<glm::vec3>("normal");
        QTest::addColumn<bool>("isMoved");
        QTest::addColumn<float>("magnitude");
        QTest::addColumn<glm::vec3>("newNormal");
        const glm::vec3 up(0, 0, 1);
        const float beyond = std::nextafter(2.0f, 3.0f);
        QTest::newRow("at the hit point the cap applies")
            << glm::vec3(0) << glm::vec3(1, 0, 0) << true << 1.0f << glm::vec3(1, 0, -1) / std::sqrt(2.0f);
        QTest::newRow("power over distance") << glm::vec3(1, 0, 0) << up << true << 0.5f << up;
        QTest::newRow("3-4-5") << glm::vec3(0.75f, 1.0f, 0) << glm::vec3(0, 1, 0) << true << 0.4f
                               << glm::vec3(0, 1, -0.4f) / std::sqrt(1.16f);
        QTest::newRow("capped") << glm::vec3(0, 0.25f, 0) << glm::vec3(0, 1, 0) << true << 1.0f
                                << glm::vec3(0, 1, -1) / std::sqrt(2.0f);
        QTest::newRow("just where the cap begins") << glm::vec3(0, 0.5f, 0) << -up << true << 1.0f << -up;
        QTest::newRow("exactly at the rim") << glm::vec3(0, 0, 2) << glm::vec3(1, 0, 0) << true << 0.25f
                                            << glm::vec3(1, 0, -0.25f) / std::sqrt(1.0625f);
        QTest::newRow("just outside the rim") << glm::vec3(0, beyond, 0) << up << false << 0.0f << up;
        QTest::newRow("far away") << glm::vec3(1e30f, 0, 0) << up << false << 0.0f << up;
        QTest::newRow("a normal that cancels out stays")
            << glm::vec3(0.25f, 0, 0) << up << true << 1.0f << up;
        QTest::newRow("a head-on hit leaves the normal") << glm::vec3(0, 1.0f, 0) << up << true << 0.5f << up;
    }
    void handWorked() {
        QFETCH(glm::vec3, position);
        QFETCH(glm::vec3, normal);
        QFETCH(bool, isMoved);
        QFETCH(float, magnitude);
        QFETCH(glm::vec3, newNormal);
        glm::vec3 p = position;
        glm::vec3 n = normal;
        QCOMPARE(deform(p, n, plainHit()), isMoved);
        QVERIFY(p == position + glm::vec3(0, 0, -magnitude));
        QVERIFY(glm::distance(n, newNormal) < 1e-7f);
    }

    void thePapersConstants() {
        Hit hit;
        hit.point = {1.0f, 2.0f, 3.0f};
        hit.direction = {1.0f, 0.0f, 0.0f};
        glm::vec3 p(1.0f, 2.0f, 3.5f);  // at the rim: moves by 0.05 / 0.5
        glm::vec3 n(0.0f, 0.0f, 1.0f);
        QVERIFY(deform(p, n, hit));
        QVERIFY(glm::distance(p, glm::vec3(1.1f, 2.0f, 3.5f)) < 1e-6f);
        QVERIFY(glm::distance(n, glm::vec3(0.1f, 0.0f, 1.0f) / std::sqrt(1.01f)) < 1e-6f);
        glm::vec3 close(1.0f, 2.1f, 3.0f);  // 0.05 / 0.1 is more than the cap
        QVERIFY(deform(close, n, hit));
        QVERIFY(glm::distance(close, glm::vec3(1.3f, 2.1f, 3.0f)) < 1e-6f);
    }

    void noPowerMovesOnlyTheHitPoint() {
        Hit hit = plainHit();
        hit.constants.power = 0.0f;
        glm::vec3 p(1.0f, 0.0f, 0.0f);
        glm::vec3 n(0.0f, 1.0f, 0.0f);
        QVERIFY(deform(p, n, hit));
        QVERIFY(p == glm::vec3(1.0f, 0.0f, 0.0f) && n == glm::vec3(0.0f, 1.0f, 0.0f));
        hit.constants.maxMagnitude = 0.0f;
        p = glm::vec3(0.0f);
        QVERIFY(deform(p, n, hit));
        QVERIFY(p == glm::vec3(0.0f));
    }

    // Weak enough that the cap would not apply a little farther out.
    void nextToTheHitPointTheCapApplies() {
        Hit hit = plainHit();
        hit.constants.power = 1e-12f;
        for (const float distance : {0.0f, 1e-44f, 1e-30f, 0.99e-11f}) {
            glm::vec3 p(distance, 0.0f, 0.0f);
            glm::vec3 n(0.0f, 1.0f, 0.0f);
            QVERIFY(deform(p, n, hit));
            QCOMPARE(p, glm::vec3(distance, 0.0f, -1.0f));
        }
        glm::vec3 p(2e-11f, 0.0f, 0.0f);
        glm::vec3 n(0.0f, 1.0f, 0.0f);
        QVERIFY(deform(p, n, hit));
        QVERIFY(std::abs(p.z + 0.05f) < 1e-6f);
    }

    void tinyComponentsOfATurnedNormalVanish() {
        for (const float tiny : {0.99e-20f, -0.99e-20f, 1e-40f, -1e-40f, -0.0f}) {
            glm::vec3 p(1.0f, 0.0f, 0.0f);
            glm::vec3 n(tiny, 1.0f, 0.0f);
            QVERIFY(deform(p, n, plainHit()));
            QVERIFY(n.x == 0.0f && !std::signbit(n.x));
        }
        glm::vec3 p(1.0f, 0.0f, 0.0f);
        glm::vec3 n(-1.1e-20f, 1.0f, 0.0f);
        QVERIFY(deform(p, n, plainHit()));
        QVERIFY(n.x < 0.0f);
    }

    // What would make denormal numbers is gone before it comes here.
    void tinyNumbersOfAHitVanish() {
        Hit hit = plainHit();
        hit.direction = {0.99e-20f, -1e-44f, -1.0f};
        hit.constants.power = 0.99e-15f;
        hit.constants.maxMagnitude = 1e-45f;
        const Hit checked = checkedHit(hit).value();
        QCOMPARE(checked.direction, glm::vec3(0.0f, 0.0f, -1.0f));
        QCOMPARE(checked.constants.power, 0.0f);
        QCOMPARE(checked.constants.maxMagnitude, 0.0f);
        const Hit twice = checkedHit(checked).value();
        QVERIFY(std::memcmp(&checked.direction, &twice.direction, sizeof(glm::vec3)) == 0);

        hit.direction = {1.1e-20f, 0.0f, -1.0f};
        hit.constants.power = 1.1e-15f;
        hit.constants.maxMagnitude = 1.1e-15f;
        const Hit kept = checkedHit(hit).value();
        QCOMPARE(kept.direction, hit.direction);
        QVERIFY(kept.constants == hit.constants);
        // Of any length: it is the unit vector's components that count.
        hit.direction = {1e-5f, 0.0f, -1e30f};
        QCOMPARE(checkedHit(hit).value().direction, glm::vec3(0.0f, 0.0f, -1.0f));
    }

    void notANumberIsOutOfReach() {
        glm::vec3 p(std::numeric_limits<float>::quiet_NaN(), 0.0f, 0.0f);
        glm::vec3 n(0.0f, 1.0f, 0.0f);
        QVERIFY(!deform(p, n, plainHit()));
        QVERIFY(n == glm::vec3(0.0f, 1.0f, 0.0f));
    }

    void everyStepIsRoundedToFloat() {
        std::mt19937 random(11);
        int moved = 0;
        for (int i = 0; i < 200000; ++i) {
            const Hit hit = test::randomHit(random, 1.0f);
            glm::vec3 p = test::randomPoint(random, 1.0f);
            glm::vec3 n = glm::normalize(test::randomPoint(random, 1.0f));
            glm::vec3 expectedPosition = p;
            glm::vec3 expectedNormal = n;
            deformRounded(expectedPosition, expectedNormal, hit);
            moved += deform(p, n, hit) ? 1 : 0;
            QVERIFY(std::memcmp(&p, &expectedPosition, sizeof p) == 0);
            QVERIFY(std::memcmp(&n, &expectedNormal, sizeof n) == 0);
        }
        QVERIFY(moved > 5000);
    }
};

HITSCOPE_TEST(DeformTest, QCoreApplication)

}  // namespace hitscope::deform_test

#include "deform_test.moc"
