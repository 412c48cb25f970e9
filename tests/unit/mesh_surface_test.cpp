// SPDX-License-Identifier: GPL-3.0-or-later
// A surface that is dented here and there, held against one that is made anew of the same vertices.
#include "physics/mesh_surface.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/vec2.hpp>
#include <set>
#include <tuple>

#include "physics/triangle_math.h"
#include "physics_support.h"
#include "support/test_program.h"

namespace hitscope::mesh_surface_test {

using namespace test;
using physics::MeshSurface;
using physics::RunPositions;
using physics::SurfaceCast;
using physics::TriangleTree;

namespace {

class Dented {
public:
    explicit Dented(const Triangles& mesh)
        : m_mesh(mesh), m_original(mesh.prepared()), m_surface(m_original) {}

    [[nodiscard]] MeshSurface& surface() { return m_surface; }
    [[nodiscard]] MeshSurface asOfNew() const { return MeshSurface(m_mesh.prepared()); }
    [[nodiscard]] const Triangles& mesh() const { return m_mesh; }
    [[nodiscard]] std::size_t vertexCount() const { return m_mesh.vertices.size(); }

    /// Vertices [first, first + count), each by `by` from its original.
    void move(std::uint32_t first, std::size_t count, const std::function<glm::vec3()>& by) {
        std::vector<DynamicVertex> moved;
        for (std::size_t i = first; i < first + count; ++i) {
            m_mesh.vertices[i] = m_original->vertices()[i] + by();
            moved.push_back({m_mesh.vertices[i], {1, 0, 0}});
        }
        m_surface.update(first, moved);
    }
    void moveBack(std::uint32_t first, std::size_t count) {
        move(first, count, [] { return glm::vec3(0.0f); });
    }

private:
    Triangles m_mesh;
    std::shared_ptr<const CollisionMesh> m_original;
    MeshSurface m_surface;
};

/// Triangles around a vertex in the middle, number 0.
Triangles fanOf(std::uint32_t spokes) {
    Triangles fan;
    fan.vertices.emplace_back(0.0f);
    for (std::uint32_t i = 0; i < spokes; ++i) {
        const float turn = 6.2831853f * static_cast<float>(i) / static_cast<float>(spokes);
        fan.vertices.emplace_back(std::cos(turn), std::sin(turn), 0.0f);
        fan.corners.insert(fan.corners.end(), {0u, 1 + i, 1 + (i + 1) % spokes});
    }
    return fan;
}

/// The triangles of a mesh halved at the median until four are left, and gone through so: of several that a
/// ray meets at once it strikes the one that comes first. What the tree has to do whatever its leaves are.
class SmallLeaves {
public:
    explicit SmallLeaves(const Triangles& mesh) {
        for (std::uint32_t i = 0; i < mesh.corners.size() / 3; ++i) {
            const auto at = [&](std::size_t k) {
                return mesh.vertices[mesh.corners[3 * std::size_t{i} + k]] / 3.0f;
            };
            m_items.push_back({at(0) + at(1) + at(2), i});
        }
        split(0, m_items.size());
    }

    /// -1: the ray meets none.
    [[nodiscard]] int firstOf(const Triangles& mesh, const glm::vec3& from, const glm::vec3& motion) const {
        int first = -1;
        double least = 2.0;
        visit(mesh, motion, 0, m_items.size(), [&](std::uint32_t triangle) {
            const auto at = [&](std::size_t k) {
                return glm::dvec3(mesh.vertices[mesh.corners[3 * std::size_t{triangle} + k]]);
            };
            const physics::Triangle candidate{at(0), at(1), at(2)};
            const auto fraction = physics::castPoint(candidate, glm::dvec3(from), glm::dvec3(motion));
            if (candidate.hasArea() && fraction && *fraction < least) {
                least = *fraction;
                first = static_cast<int>(triangle);
            }
        });
        return first;
    }

private:
    struct Item {
        glm::vec3 centre;
        std::uint32_t triangle;
    };

    void split(std::size_t begin, std::size_t count) {
        if (count <= 4) {
            std::sort(m_items.begin() + static_cast<std::ptrdiff_t>(begin),
                      m_items.begin() + static_cast<std::ptrdiff_t>(begin + count),
                      [](const Item& a, const Item& b) { return a.triangle < b.triangle; });
            return;
        }
        Bounds centres;
        for (std::size_t i = begin; i < begin + count; ++i) {
            centres.add(m_items[i].centre);
        }
        const glm::vec3 size = centres.size();
        const int axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
        const auto at = [this](std::size_t i) { return m_items.begin() + static_cast<std::ptrdiff_t>(i); };
        std::nth_element(
            at(begin), at(begin + count / 2), at(begin + count), [axis](const Item& a, const Item& b) {
                return std::tie(a.centre[axis], a.triangle) < std::tie(b.centre[axis], b.triangle);
            });
        split(begin, count / 2);
        split(begin + count / 2, count - count / 2);
    }

    [[nodiscard]] Bounds boundsOf(const Triangles& mesh, std::size_t begin, std::size_t count) const {
        Bounds bounds;
        for (std::size_t i = begin; i < begin + count; ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                bounds.add(mesh.vertices[mesh.corners[std::size_t{3} * m_items[i].triangle + k]]);
            }
        }
        return bounds;
    }

    void visit(const Triangles& mesh, const glm::vec3& direction, std::size_t begin, std::size_t count,
               const std::function<void(std::uint32_t)>& each) const {
        if (count <= 4) {
            for (std::size_t i = begin; i < begin + count; ++i) {
                each(m_items[i].triangle);
            }
            return;
        }
        const std::size_t half = count / 2;
        const Bounds left = boundsOf(mesh, begin, half);
        const Bounds right = boundsOf(mesh, begin + half, count - half);
        const bool leftFirst = glm::dot((right.min - left.min) + (right.max - left.max), direction) >= 0.0f;
        for (const bool isLeft : {leftFirst, !leftFirst}) {
            visit(mesh, direction, isLeft ? begin : begin + half, isLeft ? half : count - half, each);
        }
    }

    std::vector<Item> m_items;
};

/// All boxes of a tree, and what is in them.
std::vector<std::tuple<float, float, float>> contentOf(const MeshSurface& surface) {
    std::vector<std::tuple<float, float, float>> content;
    const Bounds all = surface.bounds();
    content.emplace_back(all.min.x, all.min.y, all.min.z);
    content.emplace_back(all.max.x, all.max.y, all.max.z);
    surface.visitWithin(all, [&content](std::uint32_t number, const physics::Triangle& triangle) {
        content.emplace_back(static_cast<float>(number), triangle.a.x, triangle.b.y);
    });
    std::sort(content.begin(), content.end());
    return content;
}

/// Nothing, or the fraction and the triangle.
std::tuple<double, int> castAt(const MeshSurface& surface, const glm::vec3& from, const glm::vec3& motion,
                               double radius) {
    const std::optional<SurfaceCast> met = surface.cast(glm::dvec3(from), glm::dvec3(motion), radius);
    return met ? std::tuple(met->fraction, met->triangle) : std::tuple(2.0, -1);
}

glm::vec3 somewhere(Random& random) {
    return 0.2f * random.direction() * random.between(0.0f, 1.0f);
}

}  // namespace

class MeshSurfaceTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void isStruckAsOneMadeAnew();
    void isDentedUntilTheLastVertexIsBack();
    void isDentedAgainAfterAWayBack();
    void resetIsTheOriginal();
    void ofManyAtOnceTheFirstOfSmallLeavesIsStruck();
    void boxesHoldNoMoreThanTheirVertices();
    void onlyChangedRunsAreOwn();
};

void MeshSurfaceTest::isStruckAsOneMadeAnew() {
    Dented dented(sphereMesh(1.0f, 60, 40));
    Random random(3);
    for (int i = 0; i < 60; ++i) {
        const std::size_t count = 1 + static_cast<std::size_t>(random.between(0, 400));
        const auto first =
            static_cast<std::uint32_t>(random.between(0, static_cast<float>(dented.vertexCount() - count)));
        dented.move(first, count, [&random] { return somewhere(random); });
        const MeshSurface anew = dented.asOfNew();
        QCOMPARE(dented.surface().bounds().min, anew.bounds().min);
        QCOMPARE(dented.surface().bounds().max, anew.bounds().max);
        for (int ray = 0; ray < 40; ++ray) {
            const glm::vec3 from = 3.0f * random.direction();
            const glm::vec3 motion = 2.0f * (0.9f * random.direction() - from);
            const double radius = ray % 2 == 0 ? 0.0 : 0.05;
            QCOMPARE(std::get<0>(castAt(dented.surface(), from, motion, radius)),
                     std::get<0>(castAt(anew, from, motion, radius)));
        }
    }
}

void MeshSurfaceTest::isDentedUntilTheLastVertexIsBack() {
    Dented dented(sphereMesh(1.0f, 60, 40));
    QVERIFY(!dented.surface().isDented());
    const auto up = [] { return glm::vec3(0.0f, 0.5f, 0.0f); };
    dented.move(10, 300, up);
    dented.move(1000, 5, up);
    QVERIFY(dented.surface().isDented());
    dented.moveBack(10, 300);
    QVERIFY(dented.surface().isDented());
    dented.moveBack(1000, 4);
    QVERIFY(dented.surface().isDented());
    dented.moveBack(1000, 5);
    QVERIFY(!dented.surface().isDented());
    QVERIFY(contentOf(dented.surface()) == contentOf(dented.asOfNew()));
}

void MeshSurfaceTest::isDentedAgainAfterAWayBack() {
    Dented dented(sphereMesh(1.0f, 60, 40));
    const auto up = [] { return glm::vec3(0.0f, 0.5f, 0.0f); };
    dented.move(0, 64, up);
    dented.move(640, 64, up);
    dented.move(128, 64, up);
    dented.moveBack(0, 64);
    dented.moveBack(128, 64);  // the search for another one passes the first run
    QVERIFY(dented.surface().isDented());
    dented.move(0, 1, up);
    dented.move(640, 64, [] { return glm::vec3(0.5f, 0.0f, 0.0f); });
    dented.moveBack(640, 64);
    QVERIFY(dented.surface().isDented());
    dented.moveBack(0, 1);
    QVERIFY(!dented.surface().isDented());
}

void MeshSurfaceTest::resetIsTheOriginal() {
    Dented dented(sphereMesh(1.0f, 60, 40));
    const auto before = contentOf(dented.surface());
    Random random(4);
    dented.move(100, 700, [&random] { return somewhere(random); });
    dented.move(1500, 3, [&random] { return somewhere(random); });
    QVERIFY(contentOf(dented.surface()) != before);
    dented.surface().reset();
    QVERIFY(!dented.surface().isDented());
    QVERIFY(contentOf(dented.surface()) == before);
}

void MeshSurfaceTest::ofManyAtOnceTheFirstOfSmallLeavesIsStruck() {
    Dented fan(fanOf(200));
    const SmallLeaves naive(fan.mesh());
    Random random(5);
    std::set<int> struck;
    for (int i = 0; i < 200; ++i) {
        // All in a plane one metre away: no rounding makes one of them nearer.
        const glm::vec3 aside = random.direction();
        const glm::vec3 from(aside.x, aside.y, i % 2 == 0 ? 1.0f : -1.0f);
        if (i % 4 == 0) {  // not the vertex in the middle
            const auto first = static_cast<std::uint32_t>(random.between(1, 190));
            fan.move(first, 10, [&random] { return glm::vec3(glm::vec2(somewhere(random)), 0.0f); });
        }
        const auto [fraction, triangle] = castAt(fan.surface(), from, -2.0f * from, 0.0);
        const int expected = naive.firstOf(fan.mesh(), from, -2.0f * from);
        QCOMPARE(fraction, 0.5);
        QCOMPARE(triangle, expected);
        struck.insert(triangle);
    }
    QVERIFY(struck.size() > 20);
}

void MeshSurfaceTest::boxesHoldNoMoreThanTheirVertices() {
    Triangles mesh = sphereMesh(1.0f, 60, 40);
    TriangleTree tree(mesh.vertices, mesh.corners);
    RunPositions at(mesh.vertices);
    const auto boxes = [](const TriangleTree& of) {
        std::vector<float> all;
        const auto accept = [&all](const Bounds& box) {
            all.insert(all.end(), {box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z});
            return true;
        };
        of.visit(glm::vec3(0.0f), accept, [](const TriangleTree::Visited&) {});
        return all;
    };
    const std::vector<float> whole = boxes(tree);
    for (const float scale : {2.0f, 0.5f, 1.0f}) {
        std::vector<TriangleTree::MovedRun> moved;
        for (const std::uint32_t run : {3u, 4u, 17u}) {
            Bounds before;
            const std::span<glm::vec3> own = at.changeRun(run);
            for (std::size_t i = 0; i < own.size(); ++i) {
                before.add(own[i]);
                own[i] = scale * mesh.vertices[RunPositions::kRun * run + i];
            }
            moved.push_back({run, before});
        }
        tree.refit(at, moved);
        QCOMPARE(boxes(tree) == whole, scale == 1.0f);
    }
}

void MeshSurfaceTest::onlyChangedRunsAreOwn() {
    const std::vector<glm::vec3> original(200, glm::vec3(1.0f));
    RunPositions at(original);
    QVERIFY(at.changed().empty());
    QCOMPARE(at.changeRun(3).size(), std::size_t{8});  // the last run is shorter
    at.changeRun(3)[7] = glm::vec3(2.0f);
    at.changeRun(1)[0] = glm::vec3(3.0f);
    QCOMPARE(at.changed().size(), std::size_t{2});
    QCOMPARE(at[199], glm::vec3(2.0f));
    QCOMPARE(at[64], glm::vec3(3.0f));
    QCOMPARE(&at[0], original.data());
    QCOMPARE(original[199], glm::vec3(1.0f));
    at.reset();
    QVERIFY(at.changed().empty());
    QCOMPARE(&at[64], original.data() + 64);
}

HITSCOPE_TEST(MeshSurfaceTest, QCoreApplication)

}  // namespace hitscope::mesh_surface_test

#include "mesh_surface_test.moc"
