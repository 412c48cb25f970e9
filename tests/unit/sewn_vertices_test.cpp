// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces that a file splits, whose vertices it repeats, are cut and measured as whole ones.
#include "mesh/surface/sewn_vertices.h"

#include <QTest>
#include <algorithm>
#include <glm/geometric.hpp>

#include "mesh/dent.h"
#include "mesh/grid_primitives.h"
#include "mesh/primitives.h"
#include "mesh/section.h"
#include "support/test_program.h"
#include "unit/mesh_support.h"
#include "unit/solids.h"

namespace hitscope::sewn_vertices_test {

namespace {

/// With the same faces turned over, at the same places; `shared`: the faces of a side share their vertices.
MeshData twoSided(const MeshData& sheet, bool shared) {
    MeshData both = shared ? sheet : test::exploded(sheet);
    const MeshData front = both;
    const auto count = static_cast<std::uint32_t>(front.vertexCount());
    for (const glm::vec3& at : front.positions) {
        both.positions.push_back(at);
    }
    for (std::size_t f = 0; f < front.faceCount(); ++f) {
        const std::span<const std::uint32_t> face = front.face(f);
        std::for_each(face.rbegin(), face.rend(),
                      [&](std::uint32_t vertex) { both.cornerVertices.push_back(vertex + count); });
        both.faceStarts.push_back(static_cast<std::uint32_t>(both.cornerVertices.size()));
    }
    return both;
}

MeshData plain(const MeshData& mesh) {
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        faces.emplace_back(mesh.face(f).begin(), mesh.face(f).end());
    }
    return test::meshOf(mesh.positions, faces);
}

/// A quarter of a metre down, within a radius of the middle.
std::vector<glm::vec3> pressed(std::span<const glm::vec3> before, float radius) {
    std::vector<glm::vec3> after(before.begin(), before.end());
    for (glm::vec3& point : after) {
        point -= glm::length(point) < radius ? glm::vec3(0.0f, 0.0f, 0.25f) : glm::vec3(0.0f);
    }
    return after;
}

std::vector<std::uint32_t> movedOf(std::span<const glm::vec3> before, std::span<const glm::vec3> after) {
    std::vector<std::uint32_t> moved;
    for (std::uint32_t v = 0; v < before.size(); ++v) {
        if (before[v] != after[v]) {
            moved.push_back(v);
        }
    }
    return moved;
}

std::vector<std::uint32_t> dentOf(const MeshSections& mesh, std::uint32_t seed,
                                  std::span<const glm::vec3> after) {
    return dentAround(seed, mesh.triangles(), mesh.positions(), after, mesh.sewn());
}

}  // namespace

class SewnVerticesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void nothingIsSewnOfAWholeSurface() {
        QVERIFY(MeshSections(buildRenderMesh(makeUvSphere(16, 8, 1.0f))).sewn().empty());
    }

    void aSplitSphereIsCutInACircle() {
        const MeshSections whole(buildRenderMesh(plain(makeUvSphere(32, 16, 1.0f))));
        const MeshSections split(buildRenderMesh(test::exploded(plain(makeUvSphere(32, 16, 1.0f)))));
        const Plane plane{glm::normalize(glm::vec3(1.0f, 2.0f, 0.5f)), 0.3f};
        const std::vector<SectionCurve> curves = split.cut(plane);
        QCOMPARE(curves.size(), std::size_t{1});
        QVERIFY(curves[0].closed);
        QCOMPARE(curves[0].points.size(), whole.cut(plane)[0].points.size());
    }

    void aSplitSheetHasOneDent_data() {
        QTest::addColumn<float>("radius");
        QTest::newRow("many vertices") << 0.5f;
        QTest::newRow("one place") << 0.01f;
    }
    void aSplitSheetHasOneDent() {
        QFETCH(const float, radius);
        const MeshSections split(buildRenderMesh(test::exploded(plain(makeSheet(20, 20, 2.0f, 2.0f)))));
        const std::vector<glm::vec3> after = pressed(split.positions(), radius);
        const std::vector<std::uint32_t> moved = movedOf(split.positions(), after);
        QVERIFY(moved.size() >= 4);
        for (const std::uint32_t seed : moved) {
            QCOMPARE(dentOf(split, seed, after), moved);
        }
        QVERIFY(dentOf(split, 0, after).empty());
    }

    /// Of more than two edges at a place, nothing says which belong together.
    void theSidesOfAThinWallStayApart_data() {
        QTest::addColumn<bool>("shared");
        QTest::newRow("shared") << true;
        QTest::newRow("split") << false;
    }
    void theSidesOfAThinWallStayApart() {
        QFETCH(const bool, shared);
        const MeshData mesh = twoSided(plain(makeSheet(8, 8, 2.0f, 2.0f)), shared);
        const MeshSections both(buildRenderMesh(mesh));
        const auto side = static_cast<std::uint32_t>(mesh.vertexCount() / 2);
        const std::vector<glm::vec3> after = pressed(both.positions(), 0.6f);
        const std::vector<std::uint32_t> moved = movedOf(both.positions(), after);
        const std::vector<std::uint32_t> front = dentOf(both, moved.front(), after);
        QVERIFY(std::all_of(front.begin(), front.end(), [side](std::uint32_t v) { return v < side; }));
        QCOMPARE(2 * front.size() == moved.size(), shared);
    }
};

HITSCOPE_TEST(SewnVerticesTest, QCoreApplication)

}  // namespace hitscope::sewn_vertices_test

#include "sewn_vertices_test.moc"
