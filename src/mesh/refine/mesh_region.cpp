// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/refine/mesh_region.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace hitscope {

namespace {

constexpr std::size_t kLeaf = 4;  // balls that are looked at one by one

Bounds boxOf(const RegionBall& ball) {
    Bounds box;
    box.add(ball.centre - glm::vec3(ball.radius));
    box.add(ball.centre + glm::vec3(ball.radius));
    return box;
}

bool meet(const Bounds& a, const Bounds& b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y &&
           a.min.z <= b.max.z && b.min.z <= a.max.z;
}

double squaredDistanceToLine(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 along = b - a;
    const double square = glm::dot(along, along);
    const double at = square > 0.0 ? std::clamp(glm::dot(point - a, along) / square, 0.0, 1.0) : 0.0;
    const glm::dvec3 rest = point - (a + at * along);
    return glm::dot(rest, rest);
}

}  // namespace

double squaredDistance(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b,
                       const glm::dvec3& c) {
    const glm::dvec3 across = glm::cross(b - a, c - a);
    const double square = glm::dot(across, across);
    const auto isInside = [&](const glm::dvec3& from, const glm::dvec3& to) {
        return glm::dot(glm::cross(to - from, point - from), across) >= 0.0;
    };
    if (square > 0.0 && isInside(a, b) && isInside(b, c) && isInside(c, a)) {
        const double height = glm::dot(point - a, across);
        return height * height / square;
    }
    return std::min({squaredDistanceToLine(point, a, b), squaredDistanceToLine(point, b, c),
                     squaredDistanceToLine(point, c, a)});
}

RegionTest::RegionTest(const MeshData& mesh, const MeshRegion& region) : m_mesh(mesh), m_region(region) {
    if (region.kind == MeshRegion::Kind::Vertices) {
        m_isNamed.assign(mesh.vertexCount(), false);
        for (const std::uint32_t vertex : region.vertices) {
            if (vertex < m_isNamed.size()) {
                m_isNamed[vertex] = true;
            }
        }
    } else if (region.kind == MeshRegion::Kind::Balls && !region.balls.empty()) {
        m_balls = region.balls;
        m_nodes.resize(1);
        build(0, 0, m_balls.size());
    }
}

/// Halves the balls across the longest side of their box until few are left.
void RegionTest::build(std::size_t node, std::size_t first, std::size_t count) {
    const auto begin = m_balls.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = begin + static_cast<std::ptrdiff_t>(count);
    Bounds box;
    std::for_each(begin, end, [&box](const RegionBall& ball) {
        const Bounds one = boxOf(ball);
        box.add(one.min);
        box.add(one.max);
    });
    m_nodes[node].box = box;
    if (count <= kLeaf) {
        m_nodes[node].first = static_cast<std::uint32_t>(first);
        m_nodes[node].count = static_cast<std::uint32_t>(count);
        return;
    }
    const glm::vec3 size = box.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::size_t half = count / 2;
    std::nth_element(
        begin, begin + static_cast<std::ptrdiff_t>(half), end,
        [axis](const RegionBall& a, const RegionBall& b) { return a.centre[axis] < b.centre[axis]; });
    const std::size_t children = m_nodes.size();
    m_nodes[node].first = static_cast<std::uint32_t>(children);
    m_nodes.resize(children + 2);
    build(children, first, half);
    build(children + 1, first + half, count - half);
}

bool RegionTest::has(std::span<const std::uint32_t> face) const {
    if (m_region.kind == MeshRegion::Kind::Vertices) {
        return std::any_of(face.begin(), face.end(),
                           [this](std::uint32_t vertex) { return m_isNamed[vertex]; });
    }
    if (m_region.kind == MeshRegion::Kind::Whole) {
        return true;
    }
    std::vector<glm::vec3> corners;
    for (const std::uint32_t vertex : face) {
        corners.push_back(m_mesh.positions[vertex]);
    }
    return isNearBall(corners);
}

std::vector<bool> RegionTest::faces() const {
    std::vector<bool> inside(m_mesh.faceCount());
    for (std::size_t f = 0; f < inside.size(); ++f) {
        inside[f] = has(m_mesh.face(f));
    }
    return inside;
}

/// Of a polygon its fan, which may cover a little more than it does.
bool RegionTest::isNearBall(std::span<const glm::vec3> corners) const {
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        if (isNearBall(corners[0], corners[i], corners[i + 1])) {
            return true;
        }
    }
    return false;
}

bool RegionTest::isNearBall(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) const {
    if (m_nodes.empty()) {
        return false;
    }
    Bounds box;
    box.add(a);
    box.add(b);
    box.add(c);
    std::array<std::uint32_t, 128> open{};  // a tree that is halved has no more than two at each of 32 levels
    std::size_t count = 0;
    open[count++] = 0;
    while (count > 0) {
        const Node& node = m_nodes[open[--count]];
        if (!meet(node.box, box)) {
            continue;
        }
        if (node.count == 0) {
            open[count++] = node.first;
            open[count++] = node.first + 1;
        }
        for (std::uint32_t i = 0; i < node.count; ++i) {
            const RegionBall& ball = m_balls[node.first + i];
            const auto radius = static_cast<double>(ball.radius);
            if (squaredDistance(glm::dvec3(ball.centre), glm::dvec3(a), glm::dvec3(b), glm::dvec3(c)) <=
                radius * radius) {
                return true;
            }
        }
    }
    return false;
}

}  // namespace hitscope
