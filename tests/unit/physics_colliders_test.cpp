// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "physics_dents.h"
#include "support/test_program.h"

namespace hitscope::physics_colliders_test {

using namespace test;

namespace {

constexpr TargetId kTarget{7};
constexpr float kRing = 1.0f;  // metres: of the torus's middle line
constexpr float kTube = 0.3f;

/// Around the x axis.
Triangles torus(int segments, int sides) {
    Triangles mesh;
    for (int i = 0; i < segments; ++i) {
        const float turn = 6.2831853f * static_cast<float>(i) / static_cast<float>(segments);
        for (int j = 0; j < sides; ++j) {
            const float around = 6.2831853f * static_cast<float>(j) / static_cast<float>(sides);
            const float r = kRing + kTube * std::cos(around);
            mesh.vertices.emplace_back(kTube * std::sin(around), r * std::cos(turn), r * std::sin(turn));
        }
    }
    const auto at = [segments, sides](int i, int j) {
        return static_cast<std::uint32_t>(i % segments * sides + j % sides);
    };
    for (int i = 0; i < segments; ++i) {
        for (int j = 0; j < sides; ++j) {
            for (const std::uint32_t corner :
                 {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1)}) {
                mesh.corners.push_back(corner);
            }
        }
    }
    return mesh;
}

glm::vec3 onRing(float radius, float turn) {
    return {0.0f, radius * std::cos(turn), radius * std::sin(turn)};
}

ProjectileSettings ball(float radius, float speed = 300.0f) {
    ProjectileSettings settings;
    settings.radius = radius;
    settings.speed = speed;
    return settings;
}

}  // namespace

/// What is hit is the surface as it is: holes are holes, dents are dents.
class PhysicsCollidersTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void torusHasAHole() {
        PhysicsWorld world;
        place(world, kTarget, {}, torus(128, 64));
        // The hole's radius is 0.7 m and the projectile's 0.1: up to 0.6 m off the axis it goes through.
        for (int i = 0; i < 24; ++i) {
            for (const float off : {0.0f, 0.3f, 0.595f}) {
                const glm::vec3 through = onRing(off, 0.3f + 0.2618f * static_cast<float>(i));
                world.shoot(through + glm::vec3(3, 0, 0), {-1, 0, 0}, ball(0.1f));
                QVERIFY(run(world, 0.05).empty());
                QVERIFY(world.projectiles().front().position.x < -1.0f);
                world.removeProjectiles();
                QVERIFY(!world.hitscan(through + glm::vec3(3, 0, 0), {-1, 0, 0}, {}));
                QVERIFY(!world.castRay(through + glm::vec3(3, 0, 0), {-1, 0, 0}, 100));
            }
        }
    }

    void torusRimIsHit() {
        PhysicsWorld world;
        place(world, kTarget, {}, torus(128, 64));
        for (int i = 0; i < 24; ++i) {
            for (const float off : {0.61f, 0.8f, 1.0f, 1.35f}) {
                const float turn = 0.3f + 0.2618f * static_cast<float>(i);
                const glm::vec3 at = onRing(off, turn);
                world.shoot(at + glm::vec3(3, 0, 0), {-1, 0, 0}, ball(0.1f));
                const auto impacts = run(world, 0.05);
                QCOMPARE(impacts.size(), std::size_t{1});
                const float fromRing = glm::length(impacts.front().point - onRing(kRing, turn));
                QVERIFY2(std::abs(fromRing - kTube) < 0.003f, qPrintable(QString::number(fromRing)));
                world.removeProjectiles();
            }
        }
        // A line meets the tube's skin, exactly.
        const auto instant = world.hitscan({3, kRing, 0}, {-1, 0, 0}, {});
        QVERIFY(instant);
        QVERIFY(glm::length(instant->point - glm::vec3(kTube, kRing, 0)) < 1e-5f);
    }

    void ballStrikesTheBottomOfADent_data() {
        QTest::addColumn<int>("kind");
        QTest::newRow("mesh") << 0;
        QTest::newRow("sphere that was exact") << 1;
    }
    void ballStrikesTheBottomOfADent() {
        QFETCH(int, kind);
        Dented dented(sphereMesh(2, 160, 80));
        const auto surface = dented.mesh().prepared();
        const Collider collider =
            kind == 0 ? Collider(MeshCollider{surface}) : Collider(SphereCollider{2, surface});
        PhysicsWorld world;
        const RigidTransform where{{4, 3, -2}, glm::angleAxis(0.7f, glm::normalize(glm::vec3(1, 2, 3)))};
        place(world, kTarget, where, collider);
        glm::vec3 bottom(2, 0, 0);
        for (int i = 0; i < 6; ++i) {
            dented.hit(bottom, {-1, 0, 0});
            world.updateTarget(kTarget, 0, dented.vertices());
            world.shoot(where.toWorld({5, 0, 0}), where.directionToWorld({-1, 0, 0}), ball(0.02f));
            const auto impacts = run(world, 0.1);
            QCOMPARE(impacts.size(), std::size_t{1});
            const Impact& impact = impacts.front();
            const glm::vec3 point = impact.where.toLocal(impact.point);
            QVERIFY(dented.distanceFromSurface(point) < 1e-4f);
            QVERIFY2(point.x < 1.9f - 0.1f * static_cast<float>(i), qPrintable(QString::number(point.x)));
            // The triangle that the record names is the one that was struck.
            QVERIFY(impact.triangle != kNoIndex);
            const std::uint32_t* corners = &dented.mesh().corners[std::size_t{3} * impact.triangle];
            QVERIFY(Dented::distance(point, dented.mesh().vertices[corners[0]],
                                     dented.mesh().vertices[corners[1]],
                                     dented.mesh().vertices[corners[2]]) < 1e-4f);
            bottom = point;
            world.removeProjectiles();
        }
        // Elsewhere it is as it was.
        const auto back = world.hitscan(where.toWorld({-5, 0, 0}), where.directionToWorld({1, 0, 0}), {});
        QVERIFY(back);
        QVERIFY(std::abs(glm::length(where.toLocal(back->point)) - 2.0f) < 0.003f);
    }

    void primitiveIsExactAgainWithoutItsDents() {
        Dented dented(sphereMesh(2, 20, 10));
        const std::vector<DynamicVertex> original = dented.vertices();
        PhysicsWorld world;
        place(world, kTarget, {}, SphereCollider{2, dented.mesh().prepared()});
        // The middle of a facet: the mesh's surface lies well inside the sphere there.
        const glm::vec3 direction = glm::normalize(dented.mesh().vertices[45] + dented.mesh().vertices[66]);
        const auto radius = [&] {
            const auto hit = world.hitscan(5.0f * direction, -direction, {});
            return hit ? glm::length(hit->point) : 0.0f;
        };
        QVERIFY(std::abs(radius() - 2.0f) < 1e-5f);
        dented.hit(-2.0f * direction, direction);
        world.updateTarget(kTarget, 0, dented.vertices());
        QVERIFY(radius() < 1.99f);
        world.updateTarget(kTarget, 0, original);
        QVERIFY(std::abs(radius() - 2.0f) < 1e-5f);
        world.updateTarget(kTarget, 0, dented.vertices());
        QVERIFY(radius() < 1.99f);
        world.resetTarget(kTarget);
        QVERIFY(std::abs(radius() - 2.0f) < 1e-5f);
    }

    /// A tree that followed many dents finds what one finds that was built over the dented mesh.
    void followingIsAsGoodAsBuildingAnew() {
        Dented dented(torus(80, 40));
        PhysicsWorld followed;
        place(followed, kTarget, {}, dented.mesh());
        Random random(23);
        for (int i = 0; i < 60; ++i) {
            const auto vertex = static_cast<std::size_t>(random.between(0, 3199.0f));
            const std::vector<DynamicVertex> before = dented.vertices();
            dented.hit(dented.mesh().vertices[vertex], random.direction());
            // As read-backs come: several ranges, cut anywhere.
            for (std::uint32_t first = 0; first < 3200;) {
                const auto count =
                    std::min(3200u - first, static_cast<std::uint32_t>(random.between(1, 900)));
                followed.updateTarget(kTarget, first, std::span(dented.vertices()).subspan(first, count));
                first += count;
            }
        }
        PhysicsWorld built;
        place(built, kTarget, {}, dented.mesh());
        int hits = 0;
        for (int i = 0; i < 2000; ++i) {
            const glm::vec3 origin = 20.0f * random.direction();
            const glm::vec3 direction = glm::normalize(2.0f * random.direction() - origin);
            const auto one = followed.hitscan(origin, direction, {});
            const auto other = built.hitscan(origin, direction, {});
            QCOMPARE(one.has_value(), other.has_value());
            if (one) {
                ++hits;
                QVERIFY(one->point == other->point && one->triangle == other->triangle);
            }
        }
        QVERIFY(hits > 300);
    }

    void restingBallFallsIntoANewDent() {
        Dented dented(fineSheet(2, 60));
        RigidTransform flat;  // the sheet's x is up
        flat.rotation = glm::angleAxis(1.5707963f, glm::vec3(0, 0, 1));
        PhysicsWorld world;
        place(world, kTarget, flat, dented.mesh());
        ProjectileSettings settings = ball(0.1f, 0.0f);
        settings.lifetime = 60.0f;
        world.shoot({0, 0.5f, 0}, {0, -1, 0}, settings);
        QVERIFY(run(world, 8).size() == 1);
        const glm::vec3 rests = world.projectiles().front().position;
        QVERIFY(std::abs(rests.y - 0.1f) < 0.01f);
        for (int i = 0; i < 3; ++i) {
            dented.hit(flat.toLocal({rests.x, -0.1f * static_cast<float>(i), rests.z}), {-1, 0, 0});
        }
        world.updateTarget(kTarget, 0, dented.vertices());
        QVERIFY(run(world, 8).size() <= 1);
        const glm::vec3 after = world.projectiles().front().position;
        QVERIFY2(after.y < -0.15f, qPrintable(QString::number(after.y)));
        QVERIFY(dented.distanceFromSurface(flat.toLocal(after)) < 0.11f);
        QVERIFY(dented.distanceFromSurface(flat.toLocal(after)) > 0.08f);
    }

    void updatesOutOfRangeAreIgnored() {
        Dented dented(fineSheet(1, 4));
        PhysicsWorld world;
        place(world, kTarget, {}, dented.mesh());
        dented.hit({0, 0, 0}, {-1, 0, 0});
        world.updateTarget(kTarget, 1, dented.vertices());
        world.updateTarget(kTarget, 4000000000u, dented.vertices());
        world.updateTarget({99}, 0, dented.vertices());
        const auto hit = world.hitscan({3, 0.1f, 0}, {-1, 0, 0}, {});
        QVERIFY(hit && std::abs(hit->point.x) < 1e-6f);
    }

    void hitscanMakesTheRecordOfAFlight() {
        PhysicsWorld world;
        place(world, kTarget, {{5, 0, 0}, {1, 0, 0, 0}}, BoxCollider{glm::vec3(1)});
        ProjectileSettings settings = ball(0.1f, 40.0f);
        settings.mass = 2.0f;
        const auto impact = world.hitscan({0, 0.25f, 0}, {3, 0, 0}, settings);
        QVERIFY(impact);
        QCOMPARE(impact->target.value, kTarget.value);
        QCOMPARE(impact->projectile.value, 0u);
        QVERIFY(glm::length(impact->point - glm::vec3(4, 0.25f, 0)) < 1e-5f);
        QVERIFY(impact->direction == glm::vec3(1, 0, 0) && impact->normal == glm::vec3(-1, 0, 0));
        QCOMPARE(impact->speed, 40.0f);
        // As a projectile: what stops it, and 0.6 * 0.6 of that to throw it back.
        QVERIFY(std::abs(impact->impulse - 2.0f * 40.0f * 1.36f) < 1e-3f);
        QCOMPARE(world.projectileCount(), std::size_t{0});
        world.setFloor(-1);
        QVERIFY(!world.hitscan({0, 5, 0}, {0, -1, 0}, settings));
        QVERIFY(!world.hitscan({0, 5, 0}, {0, 0, 0}, settings));
    }
};

HITSCOPE_TEST(PhysicsCollidersTest, QCoreApplication)

}  // namespace hitscope::physics_colliders_test

#include "physics_colliders_test.moc"
