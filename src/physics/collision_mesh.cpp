// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/collision_mesh.h"

#include <algorithm>
#include <span>
#include <utility>

#include "physics/outermost.h"
#include "physics/triangle_math.h"
#include "physics/triangle_tree.h"

namespace hitscope {

using namespace physics;

namespace {

Triangle triangleOf(std::span<const glm::vec3> vertices, const std::uint32_t* corners) {
    return {vertices[corners[0]], vertices[corners[1]], vertices[corners[2]]};
}

bool hasAnyArea(const CollisionMesh& mesh) {
    const std::vector<glm::vec3>& vertices = mesh.vertices();
    const std::span<const std::uint32_t> corners = *mesh.corners();
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        const std::uint32_t* c = &corners[i];
        if (std::max({c[0], c[1], c[2]}) < vertices.size() && triangleOf(vertices, c).hasArea()) {
            return true;
        }
    }
    return false;
}

}  // namespace

CollisionMesh::CollisionMesh(std::vector<glm::vec3> vertices, Corners corners)
    : m_vertices(std::move(vertices)),
      m_corners(std::move(corners)),
      m_tree(std::make_unique<TriangleTree>(m_vertices, *m_corners)) {
    m_hasSurface = hasAnyArea(*this);
    if (m_hasSurface) {
        m_hull = std::make_unique<Outermost>(*m_tree, RunPositions(m_vertices));
    }
}

CollisionMesh::~CollisionMesh() = default;

Bounds CollisionMesh::bounds() const {
    return m_tree->bounds();
}

}  // namespace hitscope
