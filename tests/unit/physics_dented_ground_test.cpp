// SPDX-License-Identifier: GPL-3.0-or-later
// What a dynamic target lies on once that has been dented.
#include <QTest>
#include <algorithm>
#include <cmath>

#include "physics_support.h"
#include "support/test_program.h"

namespace hitscope::physics_dented_ground_test {

using namespace test;

namespace {

constexpr TargetId kGround{1};
constexpr TargetId kBlock{2};
constexpr float kHalfHeight = 0.25f;  // metres, of the block

/// A ball, or one whose upper part is pressed down to a height.
Triangles ball(float top) {
    Triangles mesh = sphereMesh(1.0f, 32, 16);
    for (glm::vec3& vertex : mesh.vertices) {
        vertex.y = std::min(vertex.y, top);
    }
    return mesh;
}

/// Likewise, or raised where it is highest.
Triangles raised() {
    Triangles mesh = ball(1.0f);
    for (glm::vec3& vertex : mesh.vertices) {
        vertex.y += vertex.y > 0.9f ? 0.7f : 0.0f;
    }
    return mesh;
}

void dent(PhysicsWorld& world, const Triangles& to) {
    std::vector<DynamicVertex> vertices;
    for (const glm::vec3& vertex : to.vertices) {
        vertices.push_back({vertex, {0, 1, 0}});
    }
    world.updateTarget(kGround, 0, vertices);
}

void drop(PhysicsWorld& world) {
    TargetPhysics physics;
    physics.isDynamic = true;
    physics.mass = 10.0f;
    physics.restitution = 0.0f;
    place(world, kBlock, {{0, 3, 0}, {1, 0, 0, 0}}, BoxCollider{{2, kHalfHeight, 2}}, physics);
}

/// How far its underside comes down, metres.
float lowest(PhysicsWorld& world, double seconds) {
    float least = std::numeric_limits<float>::infinity();
    for (int i = 0; i < static_cast<int>(seconds / StepClock::kStep); ++i) {
        static_cast<void>(world.takeStep());
        least = std::min(least, world.dynamicTargets().front().transform.position.y - kHalfHeight);
    }
    return least;
}

}  // namespace

class PhysicsDentedGroundTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void itComesDownToTheDent_data() {
        QTest::addColumn<bool>("isRaised");
        QTest::newRow("pressed down") << false;
        QTest::newRow("raised") << true;
    }
    void itComesDownToTheDent() {
        QFETCH(bool, isRaised);
        const Triangles shape = isRaised ? raised() : ball(0.3f);
        PhysicsWorld made;
        place(made, kGround, {}, shape);
        drop(made);
        PhysicsWorld dented;
        place(dented, kGround, {}, ball(1.0f));
        dent(dented, shape);
        drop(dented);
        const float wanted = lowest(made, 1.5);
        const float height = lowest(dented, 1.5);
        QVERIFY(std::abs(wanted - (isRaised ? 1.7f : 0.3f)) < 0.02f);
        QVERIFY2(std::abs(height - wanted) < 0.02f, qPrintable(QString::number(height)));
    }

    /// It lies there, asleep, and the ground goes.
    void aDentUnderItWakesIt() {
        PhysicsWorld world;
        place(world, kGround, {}, ball(0.6f));
        drop(world);
        for (int i = 0; i < 2400 && world.isMoving(); ++i) {
            static_cast<void>(world.takeStep());
        }
        QVERIFY(!world.isMoving());
        dent(world, ball(0.6f));  // which moves nothing
        QVERIFY(!world.isMoving());
        dent(world, ball(0.3f));
        QVERIFY(world.isMoving());
        QVERIFY(std::abs(lowest(world, 1.5) - 0.3f) < 0.02f);
    }

    /// A vertex that no triangle has, however far out, is no corner of what meets the floor.
    void aVertexOfNoFaceBearsNothing() {
        for (const float moves : {0.0f, 0.01f}) {
            Triangles mesh = sphereMesh(0.5f, 32, 16);
            mesh.vertices.emplace_back(0.0f, -0.9f, 0.0f);
            PhysicsWorld world;
            world.setFloor(0.0f);
            TargetPhysics physics;
            physics.isDynamic = true;
            physics.restitution = 0.0f;
            place(world, kGround, {{0, 1, 0}, {1, 0, 0, 0}}, mesh, physics);
            for (glm::vec3& vertex : mesh.vertices) {
                vertex.y += vertex.y < -0.45f ? moves : 0.0f;
            }
            dent(world, mesh);
            for (int i = 0; i < 480; ++i) {
                static_cast<void>(world.takeStep());
            }
            const float height = world.dynamicTargets().front().transform.position.y;
            QVERIFY2(std::abs(height - 0.5f) < 0.03f, qPrintable(QString::number(height)));
        }
    }
};

HITSCOPE_TEST(PhysicsDentedGroundTest, QCoreApplication)

}  // namespace hitscope::physics_dented_ground_test

#include "physics_dented_ground_test.moc"
