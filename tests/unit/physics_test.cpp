// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/physics_world.h"

#include <QTest>
#include <cmath>
#include <limits>

#include "physics_support.h"
#include "support/test_program.h"

namespace hitscope::physics_test {

using namespace test;

namespace {

constexpr TargetId kTarget{7};
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// Distance from a box's surface, metres; local frame.
float boxDistance(const glm::vec3& p, const glm::vec3& halfExtent) {
    const glm::vec3 q = glm::abs(p) - halfExtent;
    return std::abs(glm::length(glm::max(q, glm::vec3(0))) + std::min(std::max({q.x, q.y, q.z}), 0.0f));
}

/// Where a projectile that flies along gravity's parabola is after `steps` steps, as Bullet integrates.
glm::vec3 fallen(glm::vec3 position, glm::vec3 velocity, int steps) {
    const auto dt = static_cast<float>(StepClock::kStep);
    for (int i = 0; i < steps; ++i) {
        velocity.y -= 9.81f * dt;
        position += velocity * dt;
    }
    return position;
}

}  // namespace

class PhysicsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void hitsTheBodyItIsAimedAt_data();
    void hitsTheBodyItIsAimedAt();
    void reportsTheTargetThatWasStruck();
    void directionIsTheFlights();
    void impulseStopsAndThrowsBack();
    void missMakesNoImpact();
    void gravityPullsItDown();
    void floorTakesNoHits();
    void hitsAfterTheFloor();
    void disappearsAfterItsLifetime();
    void timeIsCountedInSteps();
    void removedTargetIsNotHit();
    void refusesWhatIsNotFinite();
    void unusableTrianglesAreLeftOut();
    void castsRays();
};

void PhysicsTest::hitsTheBodyItIsAimedAt_data() {
    QTest::addColumn<int>("kind");
    QTest::newRow("sphere") << 0;
    QTest::newRow("box") << 1;
    QTest::newRow("rotated box") << 2;
    QTest::newRow("mesh") << 3;
}

void PhysicsTest::hitsTheBodyItIsAimedAt() {
    QFETCH(int, kind);
    const glm::vec3 halfExtent(1.0f, 0.5f, 2.0f);
    Collider collider;
    RigidTransform where{{4, 3, -2}, {1, 0, 0, 0}};
    switch (kind) {
        case 0:
            collider = SphereCollider{1.5f};
            break;
        case 1:
            collider = BoxCollider{halfExtent};
            break;
        case 2:
            collider = BoxCollider{halfExtent};
            where.rotation = glm::angleAxis(0.8f, glm::normalize(glm::vec3(1, 2, 3)));
            break;
        default:
            collider = sphereMesh(1.5f, 48, 24);
            where.rotation = glm::angleAxis(1.1f, glm::normalize(glm::vec3(-1, 0.5f, 1)));
    }
    Random random(11);
    for (int shot = 0; shot < 60; ++shot) {
        PhysicsWorld world;
        place(world, kTarget, where, collider);
        const glm::vec3 from = random.direction();
        // Aimed off the centre, but well within the smallest half extent.
        const glm::vec3 aim = where.position + 0.3f * random.direction();
        const glm::vec3 origin = where.position + 6.0f * from;
        const glm::vec3 direction = glm::normalize(aim - origin);
        QVERIFY(world.shoot(origin, direction, {}));
        const auto impacts = run(world, 0.5);
        QCOMPARE(impacts.size(), std::size_t{1});
        const Impact& impact = impacts.front();
        QCOMPARE(impact.target.value, kTarget.value);
        const glm::vec3 local = where.toLocal(impact.point);
        if (std::holds_alternative<BoxCollider>(collider)) {
            QVERIFY(boxDistance(local, halfExtent) < 1e-4f);
        } else {
            // A mesh's triangles lie a little inside its sphere.
            const float inside = kind == 3 ? 0.015f : 1e-4f;
            const float r = glm::length(local);
            QVERIFY2(r < 1.5f + 1e-4f && r > 1.5f - inside, qPrintable(QString::number(r)));
        }
        QVERIFY(std::abs(glm::length(impact.normal) - 1.0f) < 1e-4f);
        QVERIFY(glm::dot(impact.normal, impact.direction) < 0.0f);
        // On the line of flight, but for what gravity and the projectile's radius make of it.
        const glm::vec3 toPoint = impact.point - origin;
        QVERIFY(glm::length(toPoint - direction * glm::dot(toPoint, direction)) < 0.1f + 0.25f);
    }
}

void PhysicsTest::reportsTheTargetThatWasStruck() {
    PhysicsWorld world;
    // One behind the other: only the front one may be struck.
    place(world, {1}, {{10, 0, 0}, {1, 0, 0, 0}}, BoxCollider{glm::vec3(1)});
    place(world, {2}, {{5, 0, 0}, {1, 0, 0, 0}}, BoxCollider{glm::vec3(0.5f)});
    place(world, {3}, {{5, 0, 3}, {1, 0, 0, 0}}, SphereCollider{1});
    world.shoot({0, 0, 0}, {1, 0, 0}, {});
    const auto impacts = run(world, 1);
    QCOMPARE(impacts.size(), std::size_t{1});
    QCOMPARE(impacts.front().target.value, 2u);
    QVERIFY(std::abs(impacts.front().point.x - 4.5f) < 1e-4f);
}

void PhysicsTest::directionIsTheFlights() {
    PhysicsWorld world;
    place(world, kTarget, {{12, 0, 0}, {1, 0, 0, 0}}, BoxCollider{glm::vec3(2)});
    const ProjectileId id = world.shoot({0, 0.5f, 0}, {1, 0, 0}, {});
    const auto impacts = run(world, 1);
    QCOMPARE(impacts.size(), std::size_t{1});
    const Impact& impact = impacts.front();
    QCOMPARE(impact.projectile.value, id.value);
    // 9.9 m at 30 m/s are 79.2 steps; the impact's time is the end of its step.
    const float fall = -9.81f * static_cast<float>(impact.time);
    const glm::vec3 expected(30, fall, 0);
    QVERIFY(glm::length(impact.direction - glm::normalize(expected)) < 1e-4f);
    QVERIFY(std::abs(impact.speed - glm::length(expected)) < 1e-2f);
    QCOMPARE(std::lround(impact.time / StepClock::kStep), 80L);
}

void PhysicsTest::impulseStopsAndThrowsBack() {
    PhysicsWorld world;
    place(world, kTarget, {{6, 0, 0}, {1, 0, 0, 0}}, BoxCollider{glm::vec3(1)});
    ProjectileSettings settings;
    settings.mass = 2.0f;
    world.shoot({0, 0, 0}, {1, 0, 0}, settings);
    const auto impacts = run(world, 0.5);
    QCOMPARE(impacts.size(), std::size_t{1});
    // mass * speed stops it; with a restitution of 0.6 on both sides, 0.36 of that on top throws it back.
    const float expected = 2.0f * 30.0f * 1.36f;
    QVERIFY2(std::abs(impacts.front().impulse - expected) < 0.02f * expected,
             qPrintable(QString::number(impacts.front().impulse)));
    QVERIFY(world.projectiles().front().position.x < 4.9f);
}

void PhysicsTest::missMakesNoImpact() {
    PhysicsWorld world;
    place(world, kTarget, {{5, 0, 0}, {1, 0, 0, 0}}, SphereCollider{1});
    world.shoot({0, 1.2f, 0}, {1, 0.05f, 0}, {});
    world.shoot({0, 0, 0}, {-1, 0, 0}, {});
    QVERIFY(run(world, 1).empty());
    // A near miss that would touch if the projectile were any larger than it is.
    world.shoot({5, 10, 1.11f}, {0, -1, 0}, {});
    QVERIFY(run(world, 1).empty());
    world.shoot({5, 10, 1.09f}, {0, -1, 0}, {});
    QCOMPARE(run(world, 1).size(), std::size_t{1});
}

void PhysicsTest::gravityPullsItDown() {
    PhysicsWorld world;
    world.shoot({1, 20, 3}, {1, 0, 0}, {});
    QVERIFY(run(world, 0.5 - 1e-6).empty());
    const glm::vec3 expected = fallen({1, 20, 3}, {30, 0, 0}, 120);
    QVERIFY(glm::length(world.projectiles().front().position - expected) < 1e-3f);
}

void PhysicsTest::floorTakesNoHits() {
    PhysicsWorld world;
    world.setFloor(-1);
    world.shoot({0, 2, 0}, glm::normalize(glm::vec3(1, -1, 0)), {});
    world.shoot({0, 50, 0}, {0, -1, 0}, withSpeed(5000));
    QVERIFY(run(world, 4).empty());
    QCOMPARE(world.projectileCount(), std::size_t{2});
    for (const ProjectileState& state : world.projectiles()) {
        QVERIFY(state.position.y > -1.0f);
    }
}

void PhysicsTest::hitsAfterTheFloor() {
    PhysicsWorld world;
    world.setFloor(0);
    place(world, kTarget, {{6, 2, 0}, {1, 0, 0, 0}}, BoxCollider{{1, 2, 5}});
    world.shoot({0, 2, 0}, glm::normalize(glm::vec3(3, -2, 0)), {});
    const auto impacts = run(world, 2);
    QCOMPARE(impacts.size(), std::size_t{1});
    QVERIFY(std::abs(impacts.front().point.x - 5.0f) < 1e-4f);
    QVERIFY(impacts.front().direction.x > 0.0f && impacts.front().direction.y > 0.0f);
}

void PhysicsTest::disappearsAfterItsLifetime() {
    PhysicsWorld world;
    world.setFloor(0);
    ProjectileSettings settings;
    settings.lifetime = 0.5f;
    world.shoot({0, 1, 0}, {1, 0, 0}, settings);
    world.shoot({0, 1, 3}, {1, 0, 0}, {});
    QVERIFY(run(world, 0.45).empty());
    QCOMPARE(world.projectileCount(), std::size_t{2});
    QVERIFY(run(world, 0.1).empty());
    QCOMPARE(world.projectileCount(), std::size_t{1});
    world.removeProjectiles();
    QCOMPARE(world.projectileCount(), std::size_t{0});
}

void PhysicsTest::timeIsCountedInSteps() {
    PhysicsWorld world;
    for (int i = 0; i < 1000; ++i) {
        QVERIFY(world.advance(0.001).empty());
    }
    QVERIFY(std::abs(world.clock().time() - 1.0) < 1.5 * StepClock::kStep);
    const double before = world.clock().time();
    // A frame that took ten seconds is not caught up with.
    QVERIFY(world.advance(10).empty());
    QCOMPARE(std::lround((world.clock().time() - before) / StepClock::kStep),
             std::lround(StepClock::kLongestFrame / StepClock::kStep));
    QVERIFY(world.advance(-1).empty());
    QVERIFY(world.advance(std::numeric_limits<double>::quiet_NaN()).empty());
    QVERIFY(world.clock().time() < before + 0.26);
}

void PhysicsTest::removedTargetIsNotHit() {
    PhysicsWorld world;
    place(world, kTarget, {{5, 0, 0}, {1, 0, 0, 0}}, BoxCollider{glm::vec3(1)});
    place(world, kTarget, {{5, 0, 8}, {1, 0, 0, 0}}, BoxCollider{glm::vec3(1)});  // moved
    world.shoot({0, 0, 0}, {1, 0, 0}, {});
    QVERIFY(run(world, 0.5).empty());
    world.removeTarget(kTarget);
    world.removeTarget({99});
    world.shoot({0, 0, 8}, {1, 0, 0}, {});
    QVERIFY(run(world, 0.5).empty());
}

void PhysicsTest::refusesWhatIsNotFinite() {
    PhysicsWorld world;
    world.setFloor(kNaN);
    QVERIFY(!world.shoot({kNaN, 0, 0}, {1, 0, 0}, {}));
    QVERIFY(!world.shoot({0, 0, 0}, {0, 0, 0}, {}));
    QVERIFY(!world.shoot({0, 0, 0}, {1, kNaN, 0}, {}));
    QVERIFY(!world.shoot({1e30f, 0, 0}, {1, 0, 0}, {}));
    const auto refused = [&world](const RigidTransform& where, const Collider& collider) {
        const Status status = world.addTarget(kTarget, where, collider);
        return !status && !status.error().what.empty() && !status.error().advice.empty();
    };
    QVERIFY(refused({{kNaN, 0, 0}, {1, 0, 0, 0}}, SphereCollider{1}));
    QVERIFY(refused({{0, 0, 0}, {0, 0, 0, 0}}, SphereCollider{1}));
    QVERIFY(refused({}, SphereCollider{kNaN}));
    QVERIFY(refused({}, BoxCollider{{1, 0, 1}}));
    QVERIFY(refused({}, MeshCollider{}));
    ProjectileSettings odd{kNaN, -3.0f, 1e30f, 1e30f, true, kNaN, -4};
    QVERIFY(world.shoot({0, 0, 0}, {3, 0, 0}, odd));
    QVERIFY(run(world, 1).empty());
    QVERIFY(!world.castRay({0, 0, 0}, {kNaN, 0, 0}, 10));
    QVERIFY(!world.castRay({0, 0, 0}, {1, 0, 0}, kNaN));
}

void PhysicsTest::unusableTrianglesAreLeftOut() {
    Triangles mesh = sheet(2);
    mesh.vertices.push_back({kNaN, 0, 0});
    mesh.vertices.push_back({0, 1, 1});
    for (const std::uint32_t index : {0u, 1u, 4u, 5u, 5u, 0u, 0u, 1u, 77u, 0u}) {
        mesh.corners.push_back(index);
    }
    PhysicsWorld world;
    place(world, kTarget, {}, mesh);
    world.shoot({3, 0.5f, 0}, {-1, 0, 0}, {});
    const auto impacts = run(world, 0.5);
    QCOMPARE(impacts.size(), std::size_t{1});
    QVERIFY(std::abs(impacts.front().point.x) < 1e-4f);
}

void PhysicsTest::castsRays() {
    PhysicsWorld world;
    world.setFloor(-1);
    place(world, {1}, {{5, 0, 0}, {1, 0, 0, 0}}, SphereCollider{1});
    place(world, {2}, {{0, 0, 500}, {1, 0, 0, 0}}, sheet(3));
    world.shoot({2, 0, 0}, {0, 1, 0}, {});  // projectiles are passed over
    const auto sphere = world.castRay({0, 0, 0}, {1, 0, 0}, 100);
    QVERIFY(sphere);
    QCOMPARE(sphere->target.value, 1u);
    QVERIFY(glm::length(sphere->point - glm::vec3(4, 0, 0)) < 1e-3f);
    QVERIFY(glm::length(sphere->normal - glm::vec3(-1, 0, 0)) < 1e-3f);
    for (const float side : {-1.0f, 1.0f}) {
        const auto quad = world.castRay({side * 2, 1, 500}, {-side, 0, 0}, 10);
        QVERIFY(quad);
        QCOMPARE(quad->target.value, 2u);
        QVERIFY(glm::length(quad->point - glm::vec3(0, 1, 500)) < 1e-3f);
        QVERIFY(glm::length(quad->normal - glm::vec3(side, 0, 0)) < 1e-4f);
    }
    const auto floor = world.castRay({0, 1, 0}, {0, -1, 0}, 100);
    QVERIFY(floor);
    QCOMPARE(floor->target.value, 0u);
    QVERIFY(glm::length(floor->point - glm::vec3(0, -1, 0)) < 1e-3f);
    QVERIFY(!world.castRay({0, 0, 0}, {1, 0, 0}, 3.9f));
    QVERIFY(!world.castRay({0, 0, 0}, {0, 1, 0}, 1000));
}

HITSCOPE_TEST(PhysicsTest, QCoreApplication)

}  // namespace hitscope::physics_test

#include "physics_test.moc"
