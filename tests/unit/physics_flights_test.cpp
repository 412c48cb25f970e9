// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>

#include "physics/physics_world.h"
#include "physics_support.h"
#include "support/test_program.h"

namespace hitscope::physics_flights_test {

using namespace test;

namespace {

constexpr TargetId kTarget{7};

}  // namespace

/// Many flights: none goes through a surface, each counts as often as it should, all come out the same again.
class PhysicsFlightsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void doesNotTunnel_data();
    void doesNotTunnel();
    void doesNotTunnelThroughAMesh_data();
    void doesNotTunnelThroughAMesh();
    void bounceStaysBetweenTwoWalls();
    void bouncesCountOnlyWhenAsked();
    void restingProjectileDoesNotHitAgain();
    void comesThroughTheFloorFromBelow();
    void sameCallsGiveTheSameImpacts();
};

void PhysicsFlightsTest::doesNotTunnel_data() {
    QTest::addColumn<float>("speed");
    for (const float speed : {30.0f, 300.0f, 1000.0f, 8000.0f}) {
        QTest::addRow("%g m/s", static_cast<double>(speed)) << speed;
    }
}

void PhysicsFlightsTest::doesNotTunnel() {
    QFETCH(float, speed);
    Random random(3);
    for (int shot = 0; shot < 100; ++shot) {
        PhysicsWorld world;
        RigidTransform where;
        where.rotation = glm::angleAxis(random.between(0, 6), random.direction());
        place(world, kTarget, where, sheet(5));
        // From either side, up to 80 degrees off the normal, through anywhere on the sheet.
        const float side = shot % 2 == 0 ? 1.0f : -1.0f;
        const glm::vec3 through(0, random.between(-4, 4), random.between(-4, 4));
        const glm::vec3 slant = glm::normalize(glm::vec3(0, random.between(-1, 1), random.between(-1, 1)));
        const float angle = random.between(0, 1.4f);
        const glm::vec3 along = glm::vec3(-side * std::cos(angle), 0, 0) + std::sin(angle) * slant;
        const glm::vec3 start = through - along * random.between(1, 6);
        world.shoot(where.toWorld(start), where.directionToWorld(along), withSpeed(speed));
        const auto impacts = run(world, 0.3);
        QVERIFY2(impacts.size() == 1, qPrintable(QString("shot %1").arg(shot)));
        const glm::vec3 point = where.toLocal(impacts.front().point);
        QVERIFY(std::abs(point.x) < 1e-4f);
        // The sphere touches before its centre is there; slow shots fall a little on the way.
        QVERIFY(glm::length(point - through) < 0.1f * std::tan(angle) + 0.35f / std::cos(angle));
        const glm::vec3 end = where.toLocal(world.projectiles().front().position);
        const bool besideIt = std::max(std::abs(end.y), std::abs(end.z)) > 5.0f;
        QVERIFY2(end.x * side > 0.0f || besideIt, qPrintable(QString("shot %1").arg(shot)));
    }
}

void PhysicsFlightsTest::doesNotTunnelThroughAMesh_data() {
    doesNotTunnel_data();
}

void PhysicsFlightsTest::doesNotTunnelThroughAMesh() {
    QFETCH(float, speed);
    const Triangles mesh = sphereMesh(2, 40, 20);
    PhysicsWorld world;
    place(world, kTarget, {}, mesh);
    Random random(5);
    for (int shot = 0; shot < 100; ++shot) {
        // Half of them from inside: the surface has two sides, and none may leave.
        const bool inside = shot % 2 == 1;
        const glm::vec3 origin = inside ? glm::vec3(0) : 7.0f * random.direction();
        const glm::vec3 aim = inside ? 2.0f * random.direction() : random.direction();
        world.shoot(origin, glm::normalize(aim - origin), withSpeed(speed));
        const auto impacts = run(world, 0.3);
        QVERIFY2(impacts.size() == 1, qPrintable(QString("shot %1").arg(shot)));
        const float r = glm::length(world.projectiles().front().position);
        QVERIFY2(inside ? r < 2.0f : r > 1.98f, qPrintable(QString("shot %1: r = %2").arg(shot).arg(r)));
        world.removeProjectiles();
    }
}

void PhysicsFlightsTest::bounceStaysBetweenTwoWalls() {
    // Half a metre apart: what a bounce sends back in the same step is at the other wall long before its end.
    PhysicsWorld world;
    place(world, {1}, {}, sheet(60));
    place(world, {2}, {{0.5f, 0, 0}, {1, 0, 0, 0}}, sheet(60));
    Random random(19);
    for (int shot = 0; shot < 60; ++shot) {
        world.removeProjectiles();
        const glm::vec3 along = glm::normalize(
            glm::vec3(random.between(0.5f, 1), random.between(-0.3f, 0.3f), random.between(-0.3f, 0.3f)));
        ProjectileSettings settings = withSpeed(1000);
        settings.radius = 0.05f;
        settings.bouncesCount = true;
        world.shoot({0.25f, 0, 0}, shot % 2 == 0 ? along : -along, settings);
        for (int step = 0; step < 24; ++step) {
            QVERIFY(world.stepOnce().size() <= 2);
            const float x = world.projectiles().front().position.x;
            QVERIFY2(x > 0.0f && x < 0.5f, qPrintable(QString("shot %1: x = %2").arg(shot).arg(x)));
        }
    }
}

void PhysicsFlightsTest::bouncesCountOnlyWhenAsked() {
    for (const bool count : {false, true}) {
        PhysicsWorld world;
        // A shaft: the projectile goes back and forth between two walls.
        place(world, {1}, {{-2, 0, 0}, {1, 0, 0, 0}}, BoxCollider{{1, 20, 20}});
        place(world, {2}, {{2, 0, 0}, {1, 0, 0, 0}}, BoxCollider{{1, 20, 20}});
        ProjectileSettings settings;
        settings.bouncesCount = count;
        world.shoot({0, 5, 0}, {1, 0, 0}, settings);
        const auto impacts = run(world, 1.2);
        if (!count) {
            QCOMPARE(impacts.size(), std::size_t{1});
            continue;
        }
        QVERIFY(impacts.size() >= 3);
        for (std::size_t i = 0; i < impacts.size(); ++i) {
            QCOMPARE(impacts[i].target.value, i % 2 == 0 ? 2u : 1u);
            QCOMPARE(impacts[i].direction.x > 0.0f, i % 2 == 0);
        }
    }
}

void PhysicsFlightsTest::restingProjectileDoesNotHitAgain() {
    PhysicsWorld world;
    RigidTransform flat;
    flat.rotation = glm::angleAxis(1.5707963f, glm::vec3(0, 0, 1));
    place(world, kTarget, flat, sheet(5));
    ProjectileSettings settings;
    settings.bouncesCount = true;
    settings.speed = 0.0f;
    settings.lifetime = 20.0f;
    world.shoot({0.3f, 1, 0.3f}, {0, -1, 0}, settings);
    const std::size_t early = run(world, 3).size();
    QVERIFY(early >= 1 && early < 8);
    QVERIFY(run(world, 10).empty());
    QVERIFY(std::abs(world.projectiles().front().position.y - 0.1f) < 0.01f);
}

/// Where it is shot from below, as the aim shows it; then the floor carries it.
void PhysicsFlightsTest::comesThroughTheFloorFromBelow() {
    for (const float speed : {12.0f, 30.0f, 300.0f}) {
        PhysicsWorld world;
        world.setFloor(0.0f);
        RigidTransform where;
        where.position = {0, 3, 0};
        place(world, kTarget, where, SphereCollider{2});
        const ProjectileSettings settings = withSpeed(speed);
        const auto foreseen = world.predict({0.2f, -3, 0}, {0, 1, 0}, settings, false);
        QVERIFY(foreseen.has_value());
        world.shoot({0.2f, -3, 0}, {0, 1, 0}, settings);
        const auto impacts = run(world, 1.0);
        QVERIFY2(!impacts.empty(), qPrintable(QString::number(static_cast<double>(speed))));
        QVERIFY(glm::distance(impacts.front().point, foreseen->point) < 1e-3f);
    }
    PhysicsWorld world;
    world.setFloor(0.0f);
    ProjectileSettings settings = withSpeed(12.0f);
    settings.lifetime = 60.0f;
    world.shoot({0, -3, 0}, {0, 1, 0}, settings);
    (void)run(world, 1.0);
    QVERIFY(world.projectiles().front().position.y > 1.0f);
    (void)run(world, 20.0);
    QVERIFY(std::abs(world.projectiles().front().position.y - settings.radius) < 0.01f);
}

void PhysicsFlightsTest::sameCallsGiveTheSameImpacts() {
    const auto play = [] {
        PhysicsWorld world;
        world.setFloor(-2.5f);
        for (std::uint32_t i = 0; i < 6; ++i) {
            const RigidTransform where{
                {6.0f * static_cast<float>(i % 3), 0, 6.0f * static_cast<float>(i / 3)},
                glm::angleAxis(static_cast<float>(i), glm::vec3(0, 1, 0))};
            const Collider colliders[] = {SphereCollider{2}, BoxCollider{glm::vec3(2)},
                                          sphereMesh(2, 24, 12)};
            place(world, {i + 1}, where, colliders[i % 3]);
        }
        ProjectileSettings settings;
        settings.bouncesCount = true;
        settings.lifetime = 2.0f;
        Random random(17);
        std::vector<Impact> all;
        for (int shot = 0; shot < 200; ++shot) {
            const glm::vec3 origin(random.between(-8, 20), random.between(3, 9), -9);
            const glm::vec3 aim(random.between(0, 12), random.between(-2, 2), random.between(0, 6));
            world.shoot(origin, glm::normalize(aim - origin), settings);
            const auto impacts = world.advance(random.between(0, 0.03f));
            all.insert(all.end(), impacts.begin(), impacts.end());
        }
        const auto rest = run(world, 2);
        all.insert(all.end(), rest.begin(), rest.end());
        return all;
    };
    const auto first = play();
    QVERIFY(first.size() > 200);
    double time = 0.0;
    for (const Impact& impact : first) {
        QVERIFY(impact.time >= time);
        time = impact.time;
    }
    for (int again = 0; again < 2; ++again) {
        const auto other = play();
        QCOMPARE(other.size(), first.size());
        for (std::size_t i = 0; i < first.size(); ++i) {
            QCOMPARE(other[i].target.value, first[i].target.value);
            QCOMPARE(other[i].projectile.value, first[i].projectile.value);
            // Bit for bit: glm compares with ==.
            QVERIFY(other[i].point == first[i].point && other[i].direction == first[i].direction &&
                    other[i].normal == first[i].normal && other[i].impulse == first[i].impulse &&
                    other[i].speed == first[i].speed && other[i].time == first[i].time);
        }
    }
}

HITSCOPE_TEST(PhysicsFlightsTest, QCoreApplication)

}  // namespace hitscope::physics_flights_test

#include "physics_flights_test.moc"
