// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "physics_dents.h"
#include "support/test_program.h"

namespace hitscope::physics_bounds_test {

using namespace test;

namespace {

constexpr TargetId kTarget{7};

Triangles moved(Triangles mesh, const glm::vec3& by) {
    for (glm::vec3& vertex : mesh.vertices) {
        vertex += by;
    }
    return mesh;
}

ProjectileSettings small(float radius, float speed) {
    ProjectileSettings settings;
    settings.radius = radius;
    settings.speed = speed;
    return settings;
}

/// One flight to `aim` from `distance` metres away, against the normal -x.
std::vector<Impact> shootAt(PhysicsWorld& world, const glm::vec3& aim, float distance,
                            const ProjectileSettings& settings) {
    world.removeProjectiles();
    world.shoot(aim + glm::vec3(distance, 0, 0), {-1, 0, 0}, settings);
    return run(world, 2.0 * static_cast<double>(distance) / static_cast<double>(settings.speed) + 0.02);
}

}  // namespace

/// The odd meshes that people have: each works, or is refused with a reason.
class PhysicsBoundsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void singleTriangle() {
        PhysicsWorld world;
        place(world, kTarget, {}, Triangles{{{0, -1, -1}, {0, 1, -1}, {0, 0, 1}}, {0, 1, 2}});
        const auto hit = shootAt(world, {0, 0, 0}, 3, {});
        QCOMPARE(hit.size(), std::size_t{1});
        QVERIFY(std::abs(hit.front().point.x) < 1e-5f);
        QCOMPARE(hit.front().triangle, 0u);
        QVERIFY(shootAt(world, {0, 0.9f, 0.9f}, 3, {}).empty());
    }

    void flatSheetFromBothSides() {
        PhysicsWorld world;
        place(world, kTarget, {}, sheet(2));
        for (const float side : {-1.0f, 1.0f}) {
            world.removeProjectiles();
            world.shoot({3 * side, 0.3f, 0.4f}, {-side, 0, 0}, {});
            const auto hits = run(world, 0.5);
            QCOMPARE(hits.size(), std::size_t{1});
            QVERIFY(hits.front().normal.x * side > 0.99f);
        }
    }

    void wallOfOneTriangleStopsThemAll() {
        // Seen edge on it has no thickness at all.
        PhysicsWorld world;
        place(world, kTarget, {}, Triangles{{{0, -9, -9}, {0, 9, -9}, {0, 0, 9}}, {0, 1, 2}});
        Random random(9);
        for (const float speed : {10.0f, 30.0f, 333.0f, 1000.0f, 10000.0f}) {
            for (const float radius : {0.001f, 0.1f}) {
                for (int i = 0; i < 40; ++i) {
                    world.removeProjectiles();
                    const glm::vec3 aim(0, random.between(-3, 3), random.between(-3, 3));
                    glm::vec3 from = random.direction();
                    from.x = from.x < 0.0f ? from.x - 0.5f : from.x + 0.5f;
                    const glm::vec3 origin = aim + glm::normalize(from) * random.between(0.3f, 0.9f);
                    world.shoot(origin, glm::normalize(aim - origin), small(radius, speed));
                    const auto hits = run(world, 0.2);
                    QVERIFY2(hits.size() == 1,
                             qPrintable(QString("%1 m/s, %2 m, shot %3").arg(speed).arg(radius).arg(i)));
                    QVERIFY(world.projectiles().front().position.x * origin.x > 0.0f);
                }
            }
        }
    }

    void degenerateTrianglesAreLeftOut() {
        Triangles mesh = sheet(2);
        mesh.vertices.push_back({0, 1, 1});
        mesh.vertices.push_back({5, 0, 0});
        // A point, a line, a needle that sticks out, an index that is out of range.
        for (const std::uint32_t corner : {4u, 4u, 4u, 0u, 2u, 4u, 0u, 5u, 0u, 0u, 1u, 99u}) {
            mesh.corners.push_back(corner);
        }
        PhysicsWorld world;
        place(world, kTarget, {}, mesh);
        const auto hits = shootAt(world, {0, 0.5f, 0}, 4, {});
        QCOMPARE(hits.size(), std::size_t{1});
        QVERIFY(std::abs(hits.front().point.x) < 1e-5f);
    }

    void nothingButDegenerateTrianglesIsRefused() {
        PhysicsWorld world;
        const Triangles line{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {0, 1, 2, 0, 0, 1}};
        for (const Triangles& mesh : {line, Triangles{}, Triangles{line.vertices, {7, 8, 9}}}) {
            const Status status = world.addTarget(kTarget, {}, mesh);
            QVERIFY(!status);
            QVERIFY(!status.error().what.empty() && !status.error().advice.empty());
            QVERIFY(!world.hasTarget(kTarget));
        }
        QVERIFY(run(world, 0.1).empty());
    }

    void triangleThatADentFlattensAndRaisesAgain() {
        Triangles mesh = sheet(2);
        PhysicsWorld world;
        place(world, kTarget, {}, mesh);
        std::vector<DynamicVertex> flat(4, {{0, 0, 0}, {1, 0, 0}});
        world.updateTarget(kTarget, 0, flat);
        QVERIFY(shootAt(world, {0, 0.5f, 0}, 2, {}).empty());
        for (std::size_t i = 0; i < 4; ++i) {
            flat[i].position = mesh.vertices[i];
        }
        world.updateTarget(kTarget, 0, flat);
        QCOMPARE(shootAt(world, {0, 0.5f, 0}, 2, {}).size(), std::size_t{1});
    }

    void nonManifold() {
        // Five sheets that share one edge, and one of them twice.
        Triangles mesh;
        mesh.vertices = {{0, -1, 0}, {0, 1, 0}};
        for (int i = 0; i < 5; ++i) {
            const float turn = 1.2566371f * static_cast<float>(i);
            const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
            mesh.vertices.push_back({2 * std::cos(turn), -1, 2 * std::sin(turn)});
            mesh.vertices.push_back({2 * std::cos(turn), 1, 2 * std::sin(turn)});
            for (const std::uint32_t corner : {0u, 1u, first, 1u, first + 1, first}) {
                mesh.corners.push_back(corner);
            }
        }
        mesh.corners.insert(mesh.corners.end(), {0u, 1u, 2u, 2u, 1u, 0u});
        PhysicsWorld world;
        place(world, kTarget, {}, mesh);
        Random random(31);
        for (int i = 0; i < 40; ++i) {
            world.removeProjectiles();
            const glm::vec3 from = glm::normalize(random.direction() * glm::vec3(1, 0.1f, 1));
            world.shoot(4.0f * from, -from, withSpeed(100));
            QVERIFY(!run(world, 0.1).empty());
        }
    }

    void tinyAndHuge_data() {
        QTest::addColumn<float>("size");
        QTest::newRow("0.1 mm") << 1e-4f;
        QTest::newRow("1 m") << 1.0f;
        QTest::newRow("1,000 km") << 1e6f;
    }
    void tinyAndHuge() {
        QFETCH(float, size);
        PhysicsWorld world;
        const Triangles mesh = sphereMesh(0.5f * size, 60, 30);
        place(world, kTarget, {}, mesh);
        const auto line = world.hitscan({2 * size, 0, 0}, {-1, 0, 0}, {});
        QVERIFY(line);
        QVERIFY(std::abs(line->point.x - 0.5f * size) < 0.005f * size);
        const float speed = std::clamp(20.0f * size, 1.0f, 1000.0f);
        const float distance = std::min(0.7f * size, 100.0f);
        const auto hits = shootAt(world, {0.5f * size, 0, 0}, distance + 0.001f, small(0.001f, speed));
        QCOMPARE(hits.size(), std::size_t{1});
        const float r = glm::length(hits.front().point);
        QVERIFY2(std::abs(r - 0.5f * size) < 0.005f * size, qPrintable(QString::number(r)));
    }

    void farFromTheOrigin_data() {
        QTest::addColumn<bool>("vertices");
        QTest::newRow("its vertices") << true;
        QTest::newRow("its place") << false;
    }
    void farFromTheOrigin() {
        QFETCH(bool, vertices);
        const glm::vec3 away(1e6f, -1e6f, 1e6f);
        PhysicsWorld world;
        const Triangles mesh = sphereMesh(4, 40, 20);
        place(world, kTarget, {vertices ? glm::vec3(0) : away, {1, 0, 0, 0}},
              vertices ? moved(mesh, away) : mesh);
        const auto hits = shootAt(world, away + glm::vec3(4, 0, 0), 10, {});
        QCOMPARE(hits.size(), std::size_t{1});
        // A float is 6 cm coarse out there.
        QVERIFY(std::abs(glm::length(hits.front().point - away) - 4.0f) < 0.2f);
        world.removeProjectiles();
        world.shoot(away + glm::vec3(10, 6, 0), {-1, 0, 0}, {});
        QVERIFY(run(world, 1).empty());
    }

    /// There Bullet, which rounds to float, finds no contact with many of those that are put on the surface.
    void theyBounceFarFromTheOrigin() {
        const glm::vec3 centre(1e6f, 3e5f, -1e6f);
        PhysicsWorld world;
        place(world, kTarget, {centre, {1, 0, 0, 0}}, SphereCollider{2.5f});
        for (int i = 0; i < 24; ++i) {
            const float turn = 0.37f * static_cast<float>(i);
            const glm::vec3 outwards = glm::normalize(glm::vec3(std::cos(turn), std::sin(turn), 0.3f));
            world.removeProjectiles();
            world.shoot(centre + 6.0f * outwards, -outwards, small(0.01f, 30));
            std::vector<Impact> impacts;
            for (int step = 0; step < 60 && impacts.empty(); ++step) {
                impacts = world.takeStep();
            }
            QCOMPARE(impacts.size(), std::size_t{1});
            QVERIFY(impacts.front().impulse > 0.0f);
            const auto flights = world.projectiles();
            QCOMPARE(flights.size(), std::size_t{1});
            QVERIFY2(glm::dot(flights.front().velocity, outwards) > 0.0f, qPrintable(QString::number(i)));
        }
    }

    void beyondWhatCanBeSimulatedIsRefused() {
        PhysicsWorld world;
        for (const Collider& collider :
             {Collider(moved(sheet(1), {1e8f, 0, 0})), Collider(SphereCollider{1e8f}),
              Collider(BoxCollider{{1, 1e9f, 1}})}) {
            const Status status = world.addTarget(kTarget, {}, collider);
            QVERIFY(!status && !status.error().advice.empty());
        }
        QVERIFY(!world.addTarget(kTarget, {{1e8f, 0, 0}, {1, 0, 0, 0}}, sheet(1)));
        TargetPhysics knockable;
        knockable.isDynamic = true;
        QVERIFY(!world.addTarget(kTarget, {}, SphereCollider{1e6f}, knockable));
        place(world, kTarget, {}, SphereCollider{1e6f});
        QVERIFY(!world.setTargetPhysics(kTarget, knockable));
        QVERIFY(!world.moveTarget(kTarget, {{1e8f, 0, 0}, {1, 0, 0, 0}}));
        QVERIFY(world.hitscan({2e6f, 0, 0}, {-1, 0, 0}, {}));
    }

    void hugeVerticesAfterADent() {
        // A dent may throw vertices anywhere; what is left of the surface still takes hits.
        Triangles mesh = fineSheet(2, 8);
        PhysicsWorld world;
        place(world, kTarget, {}, mesh);
        const DynamicVertex gone{glm::vec3(std::numeric_limits<float>::quiet_NaN()), {1, 0, 0}};
        const DynamicVertex far{{3e8f, 0, 0}, {1, 0, 0}};
        world.updateTarget(kTarget, 0, {&gone, 1});
        world.updateTarget(kTarget, 80, {&far, 1});
        QCOMPARE(shootAt(world, {0, 0.1f, 0.2f}, 2, {}).size(), std::size_t{1});
    }
};

HITSCOPE_TEST(PhysicsBoundsTest, QCoreApplication)

}  // namespace hitscope::physics_bounds_test

#include "physics_bounds_test.moc"
