// SPDX-License-Identifier: GPL-3.0-or-later
// Which target a projectile strikes that touches several, or one in several places, and how hard.
#include <QTest>
#include <cmath>

#include "physics_support.h"
#include "support/test_program.h"

namespace hitscope::physics_seams_test {

using namespace test;

namespace {

constexpr RigidTransform kHere{};
constexpr glm::quat kUpright{1.0f, 0.0f, 0.0f, 0.0f};

/// A box, or its twelve triangles.
Collider boxOf(float half, bool isMesh) {
    if (!isMesh) {
        return BoxCollider{glm::vec3(half)};
    }
    Triangles mesh;
    for (unsigned i = 0; i < 8; ++i) {
        mesh.vertices.emplace_back((i & 1u) != 0 ? half : -half, (i & 2u) != 0 ? half : -half,
                                   (i & 4u) != 0 ? half : -half);
    }
    mesh.corners = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                    2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    return mesh;
}

float sumOf(const std::vector<Impact>& impacts) {
    float sum = 0.0f;
    for (const Impact& impact : impacts) {
        sum += impact.impulse;
    }
    return sum;
}

}  // namespace

class PhysicsSeamsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void besideASeamWhatIsMetFirstIsStruck_data() {
        QTest::addColumn<int>("struckId");
        QTest::addColumn<float>("lower");  // metres: the neighbour's top
        QTest::addColumn<float>("aside");  // metres, from the seam
        QTest::addColumn<bool>("isMesh");
        QTest::addColumn<bool>("bouncesCount");
        for (const int id : {1, 2}) {
            for (const float lower : {0.0f, 0.0014f, 0.01f}) {
                for (const float aside : {0.005f, 0.01f, 0.019f, 0.021f}) {
                    for (int kind = 0; kind < 4; ++kind) {
                        QTest::addRow("%d, lower by %g, %g, %d", id, static_cast<double>(lower),
                                      static_cast<double>(aside), kind)
                            << id << lower << aside << (kind % 2 == 1) << (kind > 1);
                    }
                }
            }
        }
    }
    void besideASeamWhatIsMetFirstIsStruck() {
        QFETCH(int, struckId);
        QFETCH(float, lower);
        QFETCH(float, aside);
        QFETCH(bool, isMesh);
        QFETCH(bool, bouncesCount);
        const TargetId struck{static_cast<std::uint32_t>(struckId)};
        const TargetId beside{3 - struck.value};
        PhysicsWorld world;
        place(world, beside, {{-1, -1.0f - lower, 0}, kUpright}, boxOf(1.0f, isMesh));
        place(world, struck, {{1, -1, 0}, kUpright}, boxOf(1.0f, isMesh));
        ProjectileSettings shot;
        shot.bouncesCount = bouncesCount;
        shot.lifetime = 0.2f;
        const auto foreseen = world.predict({aside, 2, 0}, {0, -1, 0}, shot, false);
        QVERIFY(foreseen && foreseen->target == struck);
        world.shoot({aside, 2, 0}, {0, -1, 0}, shot);
        const std::vector<Impact> impacts = run(world, 0.3);
        QVERIFY(!impacts.empty());
        QCOMPARE(impacts.front().target, struck);
        QVERIFY(glm::distance(impacts.front().point, foreseen->point) < 1e-3f);
        QVERIFY(glm::dot(impacts.front().normal, foreseen->normal) > 0.9999f);
        // Whoever bears the blow, all of it is counted once.
        QVERIFY2(std::abs(sumOf(impacts) - foreseen->impulse) < 0.03f * foreseen->impulse,
                 qPrintable(QStringLiteral("%1 for %2").arg(sumOf(impacts)).arg(foreseen->impulse)));
        QVERIFY(impacts.size() == 1 || (bouncesCount && impacts.size() == 2));
    }

    /// What the walls of a groove push sideways cancels out.
    void aGrooveGivesWhatTheProjectileLoses_data() {
        QTest::addColumn<float>("slope");
        QTest::newRow("flat") << 0.0f;
        QTest::newRow("shallow") << 0.5f;
        QTest::newRow("right angle") << 1.0f;
        QTest::newRow("steep") << 2.0f;
    }
    void aGrooveGivesWhatTheProjectileLoses() {
        QFETCH(float, slope);
        PhysicsWorld world;
        const Triangles groove{
            {{0, 0, -1}, {0, 0, 1}, {1, slope, -1}, {1, slope, 1}, {-1, slope, -1}, {-1, slope, 1}},
            {0, 1, 3, 0, 3, 2, 0, 5, 1, 0, 4, 5}};
        place(world, TargetId{1}, kHere, groove);
        ProjectileSettings shot;
        shot.gravity = 0.0f;
        const auto foreseen = world.predict({0, 3, 0.1f}, {0, -1, 0}, shot, false);
        world.shoot({0, 3, 0.1f}, {0, -1, 0}, shot);
        std::vector<Impact> impacts;
        for (int i = 0; i < 60 && impacts.empty(); ++i) {
            impacts = world.takeStep();
        }
        QCOMPARE(impacts.size(), std::size_t{1});
        const glm::vec3 after = world.projectiles().front().velocity;
        const float impulse = impacts.front().impulse;
        const float lost = shot.mass * glm::dot(after - glm::vec3(0, -shot.speed, 0), impacts.front().normal);
        QVERIFY2(std::abs(impulse - lost) < 0.01f * lost,
                 qPrintable(QStringLiteral("%1 for %2").arg(impulse).arg(lost)));
        if (slope <= 1.0f) {  // in a steeper one Bullet's solver does not come to an end
            QVERIFY2(std::abs(impulse - foreseen->impulse) < 0.01f * lost,
                     qPrintable(QStringLiteral("%1 for %2").arg(impulse).arg(foreseen->impulse)));
        }
    }

    void passingByIsNoHit_data() {
        QTest::addColumn<float>("gap");
        for (const float gap : {0.0002f, 0.0005f, 0.0015f, 0.0019f, 0.0025f}) {
            QTest::addRow("%g", static_cast<double>(gap)) << gap;
        }
    }
    void passingByIsNoHit() {
        QFETCH(float, gap);
        PhysicsWorld world;
        place(world, TargetId{1}, {{0, -1, 0}, kUpright}, BoxCollider{glm::vec3(1)});
        ProjectileSettings shot;
        shot.gravity = 0.0f;
        world.shoot({-3, shot.radius + gap, 0}, {1, 0, 0}, shot);
        QVERIFY(run(world, 0.4).empty());
        // Nor is flying away from where it was shot.
        world.shoot({0, shot.radius + gap, 0}, {0, 1, 0}, shot);
        QVERIFY(run(world, 0.2).empty());
    }

    /// It is near for some steps before it touches, and strikes in none of them.
    void aGrazingShotStrikesWhereItTouches() {
        for (int i = 0; i < 40; ++i) {
            PhysicsWorld world;
            place(world, TargetId{1}, {{0, -1, 0}, kUpright}, BoxCollider{glm::vec3(1)});
            ProjectileSettings shot;
            shot.gravity = 0.0f;
            shot.speed = 20.0f;
            const glm::vec3 from(-0.9f, shot.radius + 0.0005f + 0.0002f * static_cast<float>(i), 0);
            const glm::vec3 direction = glm::normalize(glm::vec3(1.0f, -0.012f, 0));
            const auto foreseen = world.predict(from, direction, shot, false);
            QVERIFY(foreseen.has_value());
            world.shoot(from, direction, shot);
            const std::vector<Impact> impacts = run(world, 0.3);
            QCOMPARE(impacts.size(), std::size_t{1});
            QVERIFY(std::abs(impacts.front().time - foreseen->time) < 1e-6);
            // So slow, along the normal, it is braked a little by Bullet the step before.
            QVERIFY(glm::distance(impacts.front().point, foreseen->point) < 0.05f);
            QVERIFY(impacts.front().impulse > 0.5f * foreseen->impulse);
        }
    }

    /// Bullet brakes a projectile in the step before it touches: it would pass by what curves away from it.
    void aGrazingShotAtACurvedMeshStrikes_data() {
        QTest::addColumn<float>("speed");
        QTest::newRow("5 m/s") << 5.0f;
        QTest::newRow("10 m/s") << 10.0f;
    }
    void aGrazingShotAtACurvedMeshStrikes() {
        QFETCH(float, speed);
        const Triangles ball = sphereMesh(1.0f, 64, 32);
        ProjectileSettings shot;
        shot.gravity = 0.0f;
        shot.speed = speed;
        int struck = 0;
        for (int i = 0; i < 60; ++i) {
            PhysicsWorld world;
            place(world, TargetId{1}, kHere, ball);
            const float off = 1.0f + shot.radius - 0.0002f * static_cast<float>(i) + 0.002f;
            const float angle = 0.37f * static_cast<float>(i);
            const glm::vec3 from(3.0f + 0.003f * static_cast<float>(i), off * std::cos(angle),
                                 off * std::sin(angle));
            const auto foreseen = world.predict(from, {-1, 0, 0}, shot, false);
            world.shoot(from, {-1, 0, 0}, shot);
            const std::vector<Impact> impacts = run(world, 1.5);
            QCOMPARE(impacts.size(), std::size_t{foreseen ? 1u : 0u});
            struck += foreseen ? 1 : 0;
            QVERIFY(!foreseen || std::abs(impacts.front().time - foreseen->time) < 1e-6);
        }
        QVERIFY2(struck > 20 && struck < 60, qPrintable(QString::number(struck)));
    }
};

HITSCOPE_TEST(PhysicsSeamsTest, QCoreApplication)

}  // namespace hitscope::physics_seams_test

#include "physics_seams_test.moc"
