// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/triangulate.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace hitscope {
namespace {

/// Twice the signed area of a triangle in the plane; positive counter-clockwise.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace

glm::dvec3 doubleAreaVector(std::span<const glm::vec3> positions, std::span<const std::uint32_t> vertices) {
    const auto at = [&](std::size_t corner) { return glm::dvec3(positions[vertices[corner]]); };
    // Nearly all faces are these; the sum below comes to the same.
    if (vertices.size() == 3) {
        return glm::cross(at(1) - at(0), at(2) - at(0));
    }
    if (vertices.size() == 4) {
        return glm::cross(at(2) - at(0), at(3) - at(1));
    }
    const glm::dvec3 origin(positions[vertices[0]]);
    glm::dvec3 sum(0.0);
    glm::dvec3 previous = glm::dvec3(positions[vertices[1]]) - origin;
    for (std::size_t i = 2; i < vertices.size(); ++i) {
        const glm::dvec3 current = glm::dvec3(positions[vertices[i]]) - origin;
        sum += glm::cross(previous, current);
        previous = current;
    }
    return sum;
}

void Triangulator::triangulate(std::span<const glm::vec3> positions, std::span<const std::uint32_t> vertices,
                               std::vector<std::uint32_t>& triangles) {
    const auto corners = static_cast<std::uint32_t>(vertices.size());
    if (corners == 3) {
        triangles.insert(triangles.end(), {0, 1, 2});
        return;
    }
    project(positions, vertices);
    if (!isConvex()) {
        clipEars(triangles);
        return;
    }
    if (corners == 4 &&
        glm::distance(glm::dvec3(positions[vertices[1]]), glm::dvec3(positions[vertices[3]])) <
            glm::distance(glm::dvec3(positions[vertices[0]]), glm::dvec3(positions[vertices[2]]))) {
        triangles.insert(triangles.end(), {0, 1, 3, 1, 2, 3});
        return;
    }
    for (std::uint32_t i = 1; i + 1 < corners; ++i) {
        triangles.insert(triangles.end(), {0, i, i + 1});
    }
}

bool Triangulator::areAsOne(std::span<const Triangulator> parts) {
    std::uint64_t work = 0;
    for (const Triangulator& part : parts) {
        work += kMostWork - part.m_workLeft;
    }
    return work < kMostWork;
}

/// Drops the coordinate in which the polygon is thinnest, keeping it counter-clockwise.
void Triangulator::project(std::span<const glm::vec3> positions, std::span<const std::uint32_t> vertices) {
    const glm::dvec3 normal = doubleAreaVector(positions, vertices);
    const glm::dvec3 size = glm::abs(normal);
    glm::length_t u = 0;
    glm::length_t v = 1;
    double orientation = normal.z;
    if (size.x >= size.y && size.x >= size.z) {
        u = 1;
        v = 2;
        orientation = normal.x;
    } else if (size.y >= size.z) {
        u = 2;
        v = 0;
        orientation = normal.y;
    }
    m_points.clear();
    for (const std::uint32_t vertex : vertices) {
        const glm::vec3& p = positions[vertex];
        m_points.emplace_back(p[u], orientation < 0.0 ? -p[v] : p[v]);
    }
}

/// Every corner turns left. (So does a pentagram's, which has no right triangulation: a fan is as good as
/// any.)
bool Triangulator::isConvex() const {
    const std::size_t count = m_points.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (!(turn(m_points[i], m_points[(i + 1) % count], m_points[(i + 2) % count]) > 0.0)) {
            return false;
        }
    }
    return true;
}

bool Triangulator::isReflex(std::uint32_t corner) const {
    return turn(m_points[m_previous[corner]], m_points[corner], m_points[m_next[corner]]) <= 0.0;
}

bool Triangulator::isEar(std::uint32_t corner) {
    if (isReflex(corner)) {
        return false;
    }
    const glm::dvec2& a = m_points[m_previous[corner]];
    const glm::dvec2& b = m_points[corner];
    const glm::dvec2& c = m_points[m_next[corner]];
    for (const std::uint32_t other : m_reflex) {
        const glm::dvec2& p = m_points[other];
        m_workLeft -= m_workLeft > 0 ? 1 : 0;
        if (m_next[other] == other || p == a || p == b || p == c) {
            continue;  // clipped already, or the same place as a corner, where a polygon touches itself
        }
        if (turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0) {
            return false;
        }
    }
    return true;
}

/// A clipped corner is its own neighbour in m_next. Where no ear is left (the polygon crosses itself, or has
/// no area) the next corner is clipped all the same, so that there are always n - 2 triangles.
void Triangulator::clipEars(std::vector<std::uint32_t>& triangles) {
    const auto count = static_cast<std::uint32_t>(m_points.size());
    m_next.resize(count);
    m_previous.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        m_next[i] = (i + 1) % count;
        m_previous[i] = (i + count - 1) % count;
    }
    m_reflex.clear();
    for (std::uint32_t i = 0; i < count; ++i) {
        if (isReflex(i)) {
            m_reflex.push_back(i);
        }
    }
    std::uint32_t corner = 0;
    std::uint32_t tried = 0;
    for (std::uint32_t left = count; left > 2;) {
        if (m_workLeft > 0 && tried < left && !isEar(corner)) {
            corner = m_next[corner];
            ++tried;
            continue;
        }
        const std::uint32_t before = m_previous[corner];
        const std::uint32_t after = m_next[corner];
        triangles.insert(triangles.end(), {before, corner, after});
        m_next[before] = after;
        m_previous[after] = before;
        m_next[corner] = corner;
        corner = m_next[after];
        --left;
        tried = 0;
    }
}

}  // namespace hitscope
