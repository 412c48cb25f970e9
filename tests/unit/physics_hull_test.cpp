// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <tuple>

#include "physics/mesh_surface.h"
#include "physics_support.h"
#include "support/test_program.h"

namespace hitscope::physics_hull_test {

using namespace test;

namespace {

std::vector<glm::vec3> sorted(std::vector<glm::vec3> points) {
    std::sort(points.begin(), points.end(), [](const glm::vec3& a, const glm::vec3& b) {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    });
    return points;
}

/// A surface that is dented, its hull following, beside one made of its vertices as they are.
class Followed {
public:
    explicit Followed(const Triangles& mesh)
        : m_mesh(mesh), m_original(mesh.prepared()), m_surface(m_original), m_hull(*m_original->hull()) {}

    /// Vertices [first, first + count) each to somewhere within `reach` of their original.
    void move(Random& random, std::uint32_t first, std::size_t count, float reach) {
        std::vector<DynamicVertex> moved;
        for (std::size_t i = first; i < first + count; ++i) {
            const glm::vec3 by = reach * random.direction() * random.between(0.0f, 1.0f);
            m_mesh.vertices[i] = m_original->vertices()[i] + by;
            moved.push_back({m_mesh.vertices[i], {1, 0, 0}});
        }
        m_surface.update(first, moved);
    }
    void reset() {
        m_mesh.vertices = m_original->vertices();
        m_surface.reset();
    }
    [[nodiscard]] bool hullIsAsOfNew() {
        m_surface.update(m_hull);
        return sorted(m_hull.points()) == sorted(m_mesh.prepared()->hull()->points());
    }
    [[nodiscard]] std::size_t vertexCount() const { return m_mesh.vertices.size(); }

private:
    Triangles m_mesh;
    std::shared_ptr<const CollisionMesh> m_original;
    physics::MeshSurface m_surface;
    physics::Outermost m_hull;
};

/// No two vertices are equally far out in any direction.
Triangles roughBall(int segments) {
    Triangles ball = sphereMesh(1.0f, segments, segments / 2);
    Random random(5);
    for (glm::vec3& vertex : ball.vertices) {
        vertex *= random.between(0.95f, 1.05f);
    }
    return ball;
}

}  // namespace

class PhysicsHullTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void followsEveryDent() {
        Followed surface(roughBall(40));
        Random random(6);
        for (int i = 0; i < 300; ++i) {
            const std::size_t count = 1 + static_cast<std::size_t>(random.between(0, 90));
            const auto first = static_cast<std::uint32_t>(
                random.between(0, static_cast<float>(surface.vertexCount() - count)));
            surface.move(random, first, count, 0.3f);
            if (i % 3 == 0) {  // several dents may come between two steps
                QVERIFY2(surface.hullIsAsOfNew(), qPrintable(QString::number(i)));
            }
        }
    }

    void followsAfterReset() {
        Followed surface(roughBall(40));
        Random random(7);
        surface.move(random, 0, surface.vertexCount(), 0.3f);
        QVERIFY(surface.hullIsAsOfNew());
        surface.reset();
        surface.move(random, 100, 5, 0.01f);
        QVERIFY(surface.hullIsAsOfNew());
        surface.reset();
        QVERIFY(surface.hullIsAsOfNew());
    }

    void followsWhenMoreMovedThanItLists() {
        Followed surface(roughBall(260));
        QVERIFY(surface.vertexCount() > 30000);
        Random random(8);
        surface.move(random, 0, surface.vertexCount(), 0.2f);
        QVERIFY(surface.hullIsAsOfNew());
        surface.move(random, 0, 200, 0.2f);
        QVERIFY(surface.hullIsAsOfNew());
    }
};

HITSCOPE_TEST(PhysicsHullTest, QCoreApplication)

}  // namespace hitscope::physics_hull_test

#include "physics_hull_test.moc"
