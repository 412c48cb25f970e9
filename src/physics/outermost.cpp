// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/outermost.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace hitscope::physics {
namespace {

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

/// How far a box reaches along `direction`.
float reach(const Bounds& box, const glm::vec3& direction) {
    const glm::vec3 corner(direction.x > 0.0f ? box.max.x : box.min.x,
                           direction.y > 0.0f ? box.max.y : box.min.y,
                           direction.z > 0.0f ? box.max.z : box.min.z);
    return glm::dot(corner, direction);
}

}  // namespace

Outermost::Outermost(const TriangleTree& tree, const RunPositions& vertices) {
    for (const glm::vec3& direction : hullDirections()) {
        m_supports.push_back({direction, glm::vec3(0.0f), -std::numeric_limits<float>::infinity(), 0});
        extend(m_supports.back(), tree, vertices);
    }
}

/// To the vertex that is farthest, if one is farther than the support; boxes that cannot hold one are passed
/// over.
void Outermost::extend(Support& support, const TriangleTree& tree, const RunPositions& vertices) {
    const auto accept = [&](const Bounds& box) { return reach(box, support.direction) > support.along; };
    tree.visitInOrder(vertices, -support.direction, accept, [&](const TriangleTree::Visited& visited) {
        for (const std::uint32_t vertex : visited.corners) {
            const float along = glm::dot(vertices[vertex], support.direction);
            if (along > support.along) {
                support = {support.direction, vertices[vertex], along, vertex};
            }
        }
    });
}

void Outermost::follow(const TriangleTree& tree, const RunPositions& vertices,
                       std::span<const std::uint32_t> moved) {
    for (Support& support : m_supports) {
        const float before = support.along;
        support.point = vertices[support.vertex];
        support.along = glm::dot(support.point, support.direction);
        for (const std::uint32_t vertex : moved) {
            const float along = glm::dot(vertices[vertex], support.direction);
            if (along > support.along) {
                support = {support.direction, vertices[vertex], along, vertex};
            }
        }
        if (support.along < before) {
            extend(support, tree, vertices);
        }
    }
}

std::vector<glm::vec3> Outermost::points() const {
    std::vector<glm::vec3> points;
    for (const Support& support : m_supports) {
        if (std::find(points.begin(), points.end(), support.point) == points.end()) {
            points.push_back(support.point);
        }
    }
    return points;
}

}  // namespace hitscope::physics
