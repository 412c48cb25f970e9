// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/collision_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <span>
#include <utility>

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
    const std::vector<std::uint32_t>& corners = *mesh.corners();
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        const std::uint32_t* c = &corners[i];
        if (std::max({c[0], c[1], c[2]}) < vertices.size() && triangleOf(vertices, c).hasArea()) {
            return true;
        }
    }
    return false;
}

/// The vertex of the tree's triangles farthest along `direction`; boxes that cannot hold it are passed over.
glm::vec3 farthestAlong(const CollisionMesh& mesh, const glm::vec3& direction) {
    float farthest = -std::numeric_limits<float>::infinity();
    glm::vec3 result(0.0f);
    const auto accept = [&](const Bounds& box) {
        const glm::vec3 corner(direction.x > 0.0f ? box.max.x : box.min.x,
                               direction.y > 0.0f ? box.max.y : box.min.y,
                               direction.z > 0.0f ? box.max.z : box.min.z);
        return glm::dot(corner, direction) > farthest;
    };
    mesh.tree().visit(-direction, accept, [&](std::uint32_t triangle) {
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec3& vertex = mesh.vertices()[(*mesh.corners())[std::size_t{3} * triangle + k]];
            if (glm::dot(vertex, direction) > farthest) {
                farthest = glm::dot(vertex, direction);
                result = vertex;
            }
        }
    });
    return result;
}

std::vector<glm::vec3> outermost(const CollisionMesh& mesh) {
    // Directions spread evenly by the golden angle, and the boxes' own axes, corners and edges.
    constexpr int kSpread = 48;
    std::vector<glm::vec3> directions;
    for (int i = 0; i < kSpread; ++i) {
        const float height = 1.0f - 2.0f * (static_cast<float>(i) + 0.5f) / kSpread;
        const float across = std::sqrt(1.0f - height * height);
        const float turn = 2.3999632f * static_cast<float>(i);
        directions.emplace_back(across * std::cos(turn), height, across * std::sin(turn));
    }
    for (int i = 0; i < 27; ++i) {
        if (i != 13) {
            directions.emplace_back(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        }
    }
    std::vector<glm::vec3> points;
    for (const glm::vec3& direction : directions) {
        const glm::vec3 point = farthestAlong(mesh, direction);
        if (std::find(points.begin(), points.end(), point) == points.end()) {
            points.push_back(point);
        }
    }
    return points;
}

}  // namespace

CollisionMesh::CollisionMesh(std::vector<glm::vec3> vertices, Corners corners)
    : m_vertices(std::move(vertices)),
      m_corners(std::move(corners)),
      m_tree(std::make_unique<TriangleTree>(m_vertices, *m_corners)) {
    m_hasSurface = hasAnyArea(*this);
    if (m_hasSurface) {
        m_hull = outermost(*this);
    }
}

CollisionMesh::~CollisionMesh() = default;

Bounds CollisionMesh::bounds() const {
    return m_tree->bounds();
}

}  // namespace hitscope
