// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/outermost.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace hitscope::physics {
namespace {

/// The vertex of the tree's triangles farthest along `direction`; boxes that cannot hold it are passed over.
glm::vec3 farthestAlong(const TriangleTree& tree, std::span<const glm::vec3> vertices,
                        std::span<const std::uint32_t> corners, const glm::vec3& direction) {
    float farthest = -std::numeric_limits<float>::infinity();
    glm::vec3 result(0.0f);
    const auto accept = [&](const Bounds& box) {
        const glm::vec3 corner(direction.x > 0.0f ? box.max.x : box.min.x,
                               direction.y > 0.0f ? box.max.y : box.min.y,
                               direction.z > 0.0f ? box.max.z : box.min.z);
        return glm::dot(corner, direction) > farthest;
    };
    tree.visit(-direction, accept, [&](std::uint32_t triangle) {
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec3& vertex = vertices[corners[std::size_t{3} * triangle + k]];
            if (glm::dot(vertex, direction) > farthest) {
                farthest = glm::dot(vertex, direction);
                result = vertex;
            }
        }
    });
    return result;
}

/// Spread evenly by the golden angle, and the boxes' own axes, corners and edges.
std::vector<glm::vec3> hullDirections() {
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
    return directions;
}

}  // namespace

std::vector<glm::vec3> outermost(const TriangleTree& tree, std::span<const glm::vec3> vertices,
                                 std::span<const std::uint32_t> corners) {
    static const std::vector<glm::vec3> directions = hullDirections();
    std::vector<glm::vec3> points;
    for (const glm::vec3& direction : directions) {
        const glm::vec3 point = farthestAlong(tree, vertices, corners, direction);
        if (std::find(points.begin(), points.end(), point) == points.end()) {
            points.push_back(point);
        }
    }
    return points;
}

}  // namespace hitscope::physics
