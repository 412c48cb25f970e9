// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "physics_dents.h"
#include "support/test_program.h"

namespace hitscope::physics_dynamic_test {

using namespace test;

namespace {

constexpr TargetId kTarget{7};

TargetPhysics knockable(float mass) {
    TargetPhysics physics;
    physics.isDynamic = true;
    physics.mass = mass;
    return physics;
}

RigidTransform poseOf(const PhysicsWorld& world) {
    return world.dynamicTargets().front().transform;
}

/// The 12 triangles of a cube, each face cut into `cells` x `cells`.
Triangles cube(float halfExtent, int cells) {
    Triangles mesh;
    const Triangles face = fineSheet(halfExtent, cells);
    const glm::quat turns[] = {{1, 0, 0, 0},
                               glm::angleAxis(3.14159265f, glm::vec3(0, 1, 0)),
                               glm::angleAxis(1.5707963f, glm::vec3(0, 1, 0)),
                               glm::angleAxis(-1.5707963f, glm::vec3(0, 1, 0)),
                               glm::angleAxis(1.5707963f, glm::vec3(0, 0, 1)),
                               glm::angleAxis(-1.5707963f, glm::vec3(0, 0, 1))};
    for (const glm::quat& turn : turns) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const glm::vec3& vertex : face.vertices) {
            mesh.vertices.push_back(turn * (vertex + glm::vec3(halfExtent, 0, 0)));
        }
        for (const std::uint32_t corner : face.corners) {
            mesh.corners.push_back(first + corner);
        }
    }
    return mesh;
}

/// The ball cut off `depth` above its lowest point: its vertices, flattened there.
std::vector<DynamicVertex> flattened(const Triangles& ball, float radius, float depth) {
    std::vector<DynamicVertex> vertices;
    for (const glm::vec3& vertex : ball.vertices) {
        vertices.push_back({{vertex.x, std::max(vertex.y, depth - radius), vertex.z}, {0, 1, 0}});
    }
    return vertices;
}

}  // namespace

/// Dynamic targets, and what hits them on the way.
class PhysicsDynamicTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void shapes_data() {
        QTest::addColumn<int>("kind");
        QTest::newRow("box") << 0;
        QTest::newRow("sphere") << 1;
        QTest::newRow("mesh") << 2;
    }
    static Collider collider(int kind) {
        return kind == 0   ? Collider(BoxCollider{glm::vec3(0.5f)})
               : kind == 1 ? Collider(SphereCollider{0.5f})
                           : Collider(cube(0.5f, 4));
    }

    void shotPushesIt_data() { shapes_data(); }
    void shotPushesIt() {
        QFETCH(int, kind);
        PhysicsWorld world;
        place(world, kTarget, {{3, 20, 0}, {1, 0, 0, 0}}, collider(kind), knockable(4));
        ProjectileSettings settings;
        settings.speed = 200.0f;  // it does not fall far on the way
        world.shoot({3 - 1.2f, 20, 0}, {1, 0, 0}, settings);
        std::vector<Impact> impacts;
        while (impacts.empty() && world.clock().time() < 0.5) {
            impacts = world.stepOnce();
        }
        QCOMPARE(impacts.size(), std::size_t{1});
        const Impact& impact = impacts.front();
        QVERIFY(std::abs(impact.point.x - 2.5f) < 1e-3f);
        // Momentum: what the projectile loses the target gains.
        const float lost = 200.0f - world.projectiles().front().velocity.x;
        QVERIFY(std::abs(impact.impulse - lost) < 0.02f * lost);
        const float before = poseOf(world).position.x;
        for (int i = 0; i < 24; ++i) {
            QVERIFY(world.stepOnce().empty());
        }
        const float speed = (poseOf(world).position.x - before) / 0.1f;
        QVERIFY2(std::abs(speed - impact.impulse / 4.0f) < 0.05f * speed, qPrintable(QString::number(speed)));
    }

    void staticStays() {
        PhysicsWorld world;
        place(world, kTarget, {{3, 0, 0}, {1, 0, 0, 0}}, collider(2));
        world.shoot({0, 0, 0}, {1, 0, 0}, {});
        QCOMPARE(run(world, 1).size(), std::size_t{1});
        QVERIFY(world.dynamicTargets().empty());
        const auto hit = world.hitscan({0, 0, 0}, {1, 0, 0}, {});
        QVERIFY(hit && std::abs(hit->point.x - 2.5f) < 1e-5f);
    }

    void standsOnWhatADentLeaves() {
        const Triangles ball = sphereMesh(0.5f, 40, 20);
        PhysicsWorld world;
        world.setFloor(-1);
        place(world, kTarget, {{0, -0.5f, 0}, {1, 0, 0, 0}}, ball, knockable(10));
        QVERIFY(run(world, 8).empty());
        QVERIFY(!world.isMoving());
        QVERIFY(std::abs(poseOf(world).position.y + 0.5f) < 0.01f);
        world.updateTarget(kTarget, 0, flattened(ball, 0.5f, 0.1f));
        QVERIFY(world.isMoving());
        QVERIFY(run(world, 4).empty());
        const float height = poseOf(world).position.y;
        QVERIFY2(std::abs(height + 0.6f) < 0.01f, qPrintable(QString::number(height)));
        world.resetTarget(kTarget);
        QVERIFY(run(world, 4).empty());
        const float again = poseOf(world).position.y;
        QVERIFY2(std::abs(again + 0.5f) < 0.01f, qPrintable(QString::number(again)));
    }

    void aDentMadeWhileStaticCounts() {
        const Triangles ball = sphereMesh(0.5f, 40, 20);
        PhysicsWorld world;
        world.setFloor(-1);
        place(world, kTarget, {{0, -0.5f, 0}, {1, 0, 0, 0}}, ball);
        world.updateTarget(kTarget, 0, flattened(ball, 0.5f, 0.1f));
        QVERIFY(run(world, 0.5).empty());
        QVERIFY(world.setTargetPhysics(kTarget, knockable(10)).ok());
        QVERIFY(run(world, 4).empty());
        const float height = poseOf(world).position.y;
        QVERIFY2(std::abs(height + 0.6f) < 0.01f, qPrintable(QString::number(height)));
    }

    void fallsAndRestsOnTheFloor_data() { shapes_data(); }
    void fallsAndRestsOnTheFloor() {
        QFETCH(int, kind);
        PhysicsWorld world;
        world.setFloor(-1);
        place(world, kTarget, {{0, 1, 0}, {1, 0, 0, 0}}, collider(kind), knockable(10));
        QVERIFY(run(world, 8).empty());
        const float height = poseOf(world).position.y;
        QVERIFY2(std::abs(height + 0.5f) < 0.01f, qPrintable(QString::number(height)));
        QVERIFY(!world.isMoving());
    }

    void pushesOtherTargets_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<int>("other");
        for (int kind = 0; kind < 3; ++kind) {
            for (int other = 0; other < 3; ++other) {
                QTest::addRow("%d on %d", kind, other) << kind << other;
            }
        }
    }
    void pushesOtherTargets() {
        QFETCH(int, kind);
        QFETCH(int, other);
        PhysicsWorld world;
        place(world, {1}, {{0, 0, 0}, {1, 0, 0, 0}}, collider(other));
        place(world, {2}, {{0, 1.3f, 0}, {1, 0, 0, 0}}, collider(kind), knockable(10));
        QVERIFY(run(world, 0.6).empty());
        // It lies on the other one, and has not sunk in.
        QVERIFY2(poseOf(world).position.y > 0.9f, qPrintable(QString::number(poseOf(world).position.y)));
    }

    void carriesItsDentsWithIt() {
        Dented dented(cube(0.5f, 24));
        PhysicsWorld world;
        world.setFloor(-0.5f);
        const auto surface = dented.mesh().prepared();
        place(world, kTarget, {}, BoxCollider{glm::vec3(0.5f), surface}, knockable(20));
        Random random(5);
        int hits = 0;
        for (int i = 0; i < 30; ++i) {
            // From all around, at where it is by now.
            const glm::vec3 from = random.direction();
            const glm::vec3 origin =
                poseOf(world).position + 3.0f * glm::vec3(from.x, 0.2f + std::abs(from.y), from.z);
            ProjectileSettings settings;
            settings.radius = 0.05f;
            settings.lifetime = 0.4f;
            world.shoot(origin, glm::normalize(poseOf(world).position - origin), settings);
            for (const Impact& impact : run(world, 0.5)) {
                ++hits;
                const glm::vec3 point = impact.where.toLocal(impact.point);
                QVERIFY2(dented.distanceFromSurface(point) < 2e-4f,
                         qPrintable(QString::number(dented.distanceFromSurface(point))));
                dented.hit(point, glm::normalize(impact.where.directionToLocal(impact.direction)));
                world.updateTarget(kTarget, 0, dented.vertices());
            }
        }
        QVERIFY(hits >= 25);
        QVERIFY(glm::length(poseOf(world).position) > 0.1f);
    }

    void offCentreHitTurnsIt() {
        PhysicsWorld world;
        place(world, kTarget, {{3, 0, 0}, {1, 0, 0, 0}}, collider(2), knockable(4));
        world.shoot({0, 0.4f, 0}, {1, 0, 0}, withSpeed(100));
        QCOMPARE(run(world, 0.2).size(), std::size_t{1});
        // Struck above its middle and pushed to +x: it turns about -z.
        QVERIFY((poseOf(world).rotation * glm::vec3(0, 1, 0)).x > 0.05f);
    }

    void meshTurnsAboutItsMiddle() {
        // The same cube about another origin behaves the same.
        Triangles shifted = cube(0.5f, 4);
        for (glm::vec3& vertex : shifted.vertices) {
            vertex += glm::vec3(0, 0.5f, 7);
        }
        PhysicsWorld one;
        PhysicsWorld other;
        place(one, kTarget, {{3, 0, 0}, {1, 0, 0, 0}}, cube(0.5f, 4), knockable(4));
        place(other, kTarget, {{3, -0.5f, -7}, {1, 0, 0, 0}}, shifted, knockable(4));
        for (PhysicsWorld* world : {&one, &other}) {
            world->shoot({0, 0.3f, 0.2f}, {1, 0, 0}, withSpeed(60));
            QCOMPARE(run(*world, 0.4).size(), std::size_t{1});
        }
        const glm::vec3 middle = poseOf(one).toWorld({0, 0, 0});
        QVERIFY(glm::length(poseOf(other).toWorld({0, 0.5f, 7}) - middle) < 0.01f);
    }

    void canBeSwitchedAndMoved() {
        PhysicsWorld world;
        place(world, kTarget, {{3, 0, 0}, {1, 0, 0, 0}}, collider(0));
        QVERIFY(world.setTargetPhysics(kTarget, knockable(1)).ok());
        QVERIFY(run(world, 0.5).empty());
        QVERIFY(poseOf(world).position.y < -1.0f);
        QVERIFY(world.moveTarget(kTarget, {{0, 9, 0}, {1, 0, 0, 0}}).ok());
        QCOMPARE(poseOf(world).position.y, 9.0f);
        QVERIFY(world.setTargetPhysics(kTarget, {}).ok());
        QVERIFY(run(world, 0.5).empty());
        const auto hit = world.hitscan({-5, 9, 0}, {1, 0, 0}, {});
        QVERIFY(hit && std::abs(hit->point.x + 0.5f) < 1e-5f);
    }
};

HITSCOPE_TEST(PhysicsDynamicTest, QCoreApplication)

}  // namespace hitscope::physics_dynamic_test

#include "physics_dynamic_test.moc"
