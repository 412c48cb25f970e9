// SPDX-License-Identifier: GPL-3.0-or-later
// A dent is as deep whichever way the faces of its body point.
#include <algorithm>
#include <glm/geometric.hpp>

#include "mesh/dent.h"
#include "mesh/primitives.h"
#include "mesh/render_mesh.h"
#include "mesh/section.h"
#include "support/test_program.h"

namespace hitscope::dent_orientation_test {

class DentOrientationTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        const RenderMesh mesh = buildRenderMesh(makeHighPolySphere());
        const MeshSections sections(mesh);
        m_triangles.assign(sections.triangles().begin(), sections.triangles().end());
        m_before.assign(sections.positions().begin(), sections.positions().end());
    }

    void insideOutBodiesAreDentedAsDeep() {
        push(-0.2f);
        const DentMeasures right = measured(m_triangles);
        const DentMeasures inverted = measured(turned());
        QVERIFY(right.depth > 0.19 && right.displacedVolume > 0.0);
        QCOMPARE(inverted.depth, right.depth);
        QVERIFY(std::abs(inverted.displacedVolume / right.displacedVolume - 1.0) < 1.0e-9);
        QVERIFY(glm::distance(inverted.axis, right.axis) < 1.0e-6f);
    }

    /// What sticks out of a body is no dent.
    void bumpsHaveNoDepth() {
        push(0.2f);
        const DentMeasures bump = measured(m_triangles);
        QCOMPARE(bump.depth, 0.0);
        QVERIFY(bump.displacedVolume < 0.0);
        // It is marked in its midst, or where it sticks out farthest.
        const auto upright = [this](std::uint32_t vertex) { return glm::normalize(m_before[vertex]).y; };
        QVERIFY(upright(bump.deepest) > 0.999f);
        const std::uint32_t farthest =
            *std::min_element(m_vertices.begin(), m_vertices.end(),
                              [&](std::uint32_t a, std::uint32_t b) { return upright(a) < upright(b); });
        m_after[farthest] += 0.1f * glm::normalize(m_before[farthest]);
        QCOMPARE(measured(m_triangles).deepest, farthest);
    }

    /// Of a room, whose faces point inwards, walls are pushed outwards from within.
    void roomsAreDentedFromWithin() {
        push(0.2f);
        const DentMeasures wall = measured(turned());
        QVERIFY(wall.depth > 0.19);
        QVERIFY(wall.displacedVolume > 0.0);
    }

private:
    /// The vertices at the top by so much, along the radius.
    void push(float way) {
        m_after = m_before;
        m_vertices.clear();
        for (std::uint32_t v = 0; v < m_before.size(); ++v) {
            const glm::vec3 out = glm::normalize(m_before[v]);
            if (out.y > 0.97f) {
                m_after[v] += way * out;
                m_vertices.push_back(v);
            }
        }
        QVERIFY(m_vertices.size() > 10);
    }
    [[nodiscard]] std::vector<std::uint32_t> turned() const {
        std::vector<std::uint32_t> triangles = m_triangles;
        for (std::size_t first = 0; first + 2 < triangles.size(); first += 3) {
            std::swap(triangles[first], triangles[first + 1]);
        }
        return triangles;
    }
    [[nodiscard]] DentMeasures measured(const std::vector<std::uint32_t>& triangles) const {
        return measureDent(m_vertices, triangles, m_before, m_after).value_or(DentMeasures{});
    }

    std::vector<std::uint32_t> m_triangles;
    std::vector<glm::vec3> m_before;
    std::vector<glm::vec3> m_after;
    std::vector<std::uint32_t> m_vertices;
};

HITSCOPE_TEST(DentOrientationTest, QCoreApplication)

}  // namespace hitscope::dent_orientation_test

#include "dent_orientation_test.moc"
