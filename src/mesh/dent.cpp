// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/dent.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <numeric>

namespace hitscope {

namespace {

using Corners = std::array<glm::dvec3, 3>;

Corners cornersOf(std::span<const std::uint32_t> triangle, std::span<const glm::vec3> positions) {
    return {glm::dvec3(positions[triangle[0]]), glm::dvec3(positions[triangle[1]]),
            glm::dvec3(positions[triangle[2]])};
}

/// Its length is the area.
glm::dvec3 areaVector(const Corners& corners) {
    return 0.5 * glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
}

/// That a triangle passes through on its straight way, signed: along its area vector positive. The way is the
/// corners' mean one, and the area vector a polynomial of how far they have come, which is integrated.
double sweptVolume(const Corners& before, const Corners& after) {
    const glm::dvec3 a = before[1] - before[0];
    const glm::dvec3 b = before[2] - before[0];
    const glm::dvec3 aTurn = after[1] - after[0] - a;
    const glm::dvec3 bTurn = after[2] - after[0] - b;
    const glm::dvec3 area = 0.5 * (glm::cross(a, b) + (glm::cross(a, bTurn) + glm::cross(aTurn, b)) / 2.0 +
                                   glm::cross(aTurn, bTurn) / 3.0);
    const glm::dvec3 way = (after[0] - before[0] + after[1] - before[1] + after[2] - before[2]) / 3.0;
    return glm::dot(way, area);
}

/// Two directions at right angles to `axis` and to each other: the first level, unless the axis is upright.
std::array<glm::vec3, 2> across(const glm::vec3& axis) {
    const glm::vec3 level = glm::cross(glm::vec3(0.0f, 1.0f, 0.0f), axis);
    const glm::vec3 first = glm::length(level) > 1.0e-3f
                                ? glm::normalize(level)
                                : glm::normalize(glm::vec3(1.0f, 0.0f, 0.0f) - axis * axis.x);
    return {first, glm::cross(axis, first)};
}

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// Andrew's monotone chain; counter-clockwise.
std::vector<glm::dvec2> hullOf(std::vector<glm::dvec2> points) {
    std::sort(points.begin(), points.end(), [](const glm::dvec2& a, const glm::dvec2& b) {
        return a.x < b.x || (a.x == b.x && a.y < b.y);
    });
    std::vector<glm::dvec2> hull;
    const auto add = [&hull](const glm::dvec2& point, std::size_t least) {
        while (hull.size() > least &&
               cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0.0) {
            hull.pop_back();
        }
        hull.push_back(point);
    };
    std::for_each(points.begin(), points.end(), [&](const glm::dvec2& point) { add(point, 1); });
    const std::size_t lower = hull.size();
    std::for_each(points.rbegin(), points.rend(), [&](const glm::dvec2& point) { add(point, lower); });
    return hull;
}

double widthAcross(std::span<const std::uint32_t> vertices, std::span<const glm::vec3> positions,
                   const glm::vec3& axis) {
    const std::array<glm::vec3, 2> directions = across(axis);
    std::vector<glm::dvec2> flat;
    flat.reserve(vertices.size());
    for (const std::uint32_t vertex : vertices) {
        flat.emplace_back(glm::dot(positions[vertex], directions[0]),
                          glm::dot(positions[vertex], directions[1]));
    }
    double greatest = 0.0;
    const std::vector<glm::dvec2> hull = hullOf(std::move(flat));
    for (const glm::dvec2& a : hull) {
        for (const glm::dvec2& b : hull) {
            greatest = std::max(greatest, glm::distance(a, b));
        }
    }
    return greatest;
}

/// Sets depth and deepest. The cap makes bottoms flat: of those that are as deep, the one in their midst.
/// Where none went inwards, the depth is 0 and those count that moved farthest.
void findDeepest(DentMeasures& dent, std::span<const std::uint32_t> vertices,
                 std::span<const glm::vec3> before, std::span<const glm::vec3> after) {
    constexpr double kAsDeep = 1.0 - 1.0e-4;
    bool isInwards = true;
    const auto depthOf = [&](std::uint32_t vertex) {
        const glm::dvec3 moved = glm::dvec3(after[vertex]) - glm::dvec3(before[vertex]);
        return isInwards ? glm::dot(moved, glm::dvec3(dent.axis)) : glm::length(moved);
    };
    const auto greatest = [&] {
        return std::accumulate(vertices.begin(), vertices.end(), 0.0, [&](double most, std::uint32_t vertex) {
            return std::max(most, depthOf(vertex));
        });
    };
    dent.depth = greatest();
    isInwards = dent.depth > 0.0;
    const double most = isInwards ? dent.depth : greatest();
    glm::dvec3 sum(0.0);
    double count = 0.0;
    for (const std::uint32_t vertex : vertices) {
        if (depthOf(vertex) >= kAsDeep * most) {
            sum += glm::dvec3(before[vertex]);
            count += 1.0;
        }
    }
    const glm::dvec3 middle = count > 0.0 ? sum / count : glm::dvec3(before[vertices.front()]);
    double nearest = std::numeric_limits<double>::infinity();
    dent.deepest = vertices.front();
    for (const std::uint32_t vertex : vertices) {
        const double distance = glm::distance(glm::dvec3(before[vertex]), middle);
        if (depthOf(vertex) >= kAsDeep * most && distance < nearest) {
            nearest = distance;
            dent.deepest = vertex;
        }
    }
}

glm::dvec3 meanMotion(std::span<const std::uint32_t> vertices, std::span<const glm::vec3> before,
                      std::span<const glm::vec3> after) {
    glm::dvec3 sum(0.0);
    for (const std::uint32_t vertex : vertices) {
        sum += glm::dvec3(after[vertex]) - glm::dvec3(before[vertex]);
    }
    return sum / static_cast<double>(vertices.size());
}

/// normal: the sum of area vectors that are `area` long together. Where they point all over, as on both
/// sides of a thin limb, what is left of them says nothing of the way into the surface; how it moved does.
glm::vec3 axisOf(const glm::dvec3& normal, double area, const glm::dvec3& motion) {
    constexpr double kAgree = 0.5;
    const double length = glm::length(normal);
    if (length >= kAgree * area) {
        return -normal / length;
    }
    if (const double moved = glm::length(motion); moved > 1.0e-9 * std::sqrt(area)) {
        return motion / moved;
    }
    return length > 1.0e-9 * area ? glm::vec3(-normal / length) : glm::vec3(0.0f, -1.0f, 0.0f);
}

/// The faces of a body that was exported inside out point at its middle. Open and flat meshes, whose faces do
/// not say, count as they are.
bool isInsideOut(std::span<const std::uint32_t> triangles, std::span<const glm::vec3> positions) {
    constexpr double kFlat = 0.1;  // of what the sum would be if all faces pointed away from the middle
    glm::dvec3 middle(0.0);
    double area = 0.0;
    for (std::size_t first = 0; first + 2 < triangles.size(); first += 3) {
        const Corners corners = cornersOf(triangles.subspan(first, 3), positions);
        const double its = glm::length(areaVector(corners));
        middle += its * (corners[0] + corners[1] + corners[2]) / 3.0;
        area += its;
    }
    middle = area > 0.0 ? middle / area : middle;
    double outwards = 0.0;
    double most = 0.0;
    for (std::size_t first = 0; first + 2 < triangles.size(); first += 3) {
        const Corners corners = cornersOf(triangles.subspan(first, 3), positions);
        const glm::dvec3 way = (corners[0] + corners[1] + corners[2]) / 3.0 - middle;
        const glm::dvec3 its = areaVector(corners);
        outwards += glm::dot(its, way);
        most += glm::length(its) * glm::length(way);
    }
    return outwards < -kFlat * most;
}

/// Of a set of vertices, root of each: neighbours that moved come to have the same.
class Sets {
public:
    explicit Sets(std::size_t count) : m_parents(count) {
        for (std::size_t i = 0; i < count; ++i) {
            m_parents[i] = static_cast<std::uint32_t>(i);
        }
    }
    std::uint32_t rootOf(std::uint32_t vertex) {
        while (m_parents[vertex] != vertex) {
            vertex = m_parents[vertex] = m_parents[m_parents[vertex]];
        }
        return vertex;
    }
    void join(std::uint32_t a, std::uint32_t b) { m_parents[rootOf(a)] = rootOf(b); }

private:
    std::vector<std::uint32_t> m_parents;
};

}  // namespace

std::vector<std::uint32_t> dentAround(std::uint32_t seed, std::span<const std::uint32_t> triangles,
                                      std::span<const glm::vec3> before, std::span<const glm::vec3> after,
                                      std::span<const std::uint32_t> sewn) {
    const auto moved = [&](std::uint32_t vertex) { return before[vertex] != after[vertex]; };
    if (seed >= before.size() || !moved(seed)) {
        return {};
    }
    Sets sets(before.size());
    for (std::size_t first = 0; first + 2 < triangles.size(); first += 3) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t a = triangles[first + corner];
            const std::uint32_t b = triangles[first + (corner + 1) % 3];
            if (moved(a) && moved(b)) {
                sets.join(a, b);
            }
        }
    }
    for (std::uint32_t vertex = 0; vertex < sewn.size(); ++vertex) {
        sets.join(vertex, sewn[vertex]);  // hits move all vertices of a place alike
    }
    std::vector<std::uint32_t> dent;
    for (std::uint32_t vertex = 0; vertex < before.size(); ++vertex) {
        if (moved(vertex) && sets.rootOf(vertex) == sets.rootOf(seed)) {
            dent.push_back(vertex);
        }
    }
    return dent;
}

std::optional<DentMeasures> measureDent(std::span<const std::uint32_t> vertices,
                                        std::span<const std::uint32_t> triangles,
                                        std::span<const glm::vec3> before, std::span<const glm::vec3> after,
                                        std::span<const std::uint32_t> whole) {
    if (vertices.empty()) {
        return std::nullopt;
    }
    const auto cornersIn = [](std::span<const std::uint32_t> part, std::span<const std::uint32_t> triangle) {
        return static_cast<double>(std::count_if(
            triangle.begin(), triangle.end(),
            [part](std::uint32_t vertex) { return std::binary_search(part.begin(), part.end(), vertex); }));
    };
    DentMeasures dent;
    dent.vertices = vertices.size();
    glm::dvec3 normal(0.0);
    double area = 0.0;
    double corneredArea = 0.0;
    for (std::size_t first = 0; first + 2 < triangles.size(); first += 3) {
        const std::span<const std::uint32_t> triangle = triangles.subspan(first, 3);
        const double corners = cornersIn(vertices, triangle);
        if (corners == 0.0) {
            continue;
        }
        const Corners was = cornersOf(triangle, before);
        const glm::dvec3 itsArea = areaVector(was);
        normal += itsArea * corners;
        area += glm::length(itsArea);
        corneredArea += glm::length(itsArea) * corners;
        dent.affectedArea += glm::length(itsArea) * corners / 3.0;
        const double share = whole.empty() ? 1.0 : corners / cornersIn(whole, triangle);
        dent.displacedVolume -= share * sweptVolume(was, cornersOf(triangle, after));
    }
    if (area == 0.0) {
        return std::nullopt;
    }
    const glm::dvec3 motion = meanMotion(vertices, before, after);
    if (glm::dot(motion, normal) > 0.0 && isInsideOut(triangles, before)) {
        normal = -normal;
        dent.displacedVolume = -dent.displacedVolume;
    }
    dent.axis = axisOf(normal, corneredArea, motion);
    findDeepest(dent, vertices, before, after);
    dent.rimDiameter = widthAcross(vertices, before, dent.axis);
    return dent;
}

Plane profilePlane(const DentMeasures& dent, const glm::vec3& deepestBefore, float angle) {
    const std::array<glm::vec3, 2> directions = across(dent.axis);
    const glm::vec3 along = std::cos(angle) * directions[0] + std::sin(angle) * directions[1];
    const glm::vec3 normal = glm::normalize(glm::cross(along, dent.axis));
    return {normal, glm::dot(normal, deepestBefore)};
}

ProfilePoint toProfile(const Plane& plane, const DentMeasures& dent, const glm::vec3& deepestBefore,
                       const glm::vec3& point) {
    const glm::dvec3 from = glm::dvec3(point) - glm::dvec3(deepestBefore);
    const glm::dvec3 along = glm::cross(glm::dvec3(dent.axis), glm::dvec3(plane.normal));
    return {glm::dot(from, along), -glm::dot(from, glm::dvec3(dent.axis))};
}

}  // namespace hitscope
