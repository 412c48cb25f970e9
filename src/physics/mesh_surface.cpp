// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/mesh_surface.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <utility>

namespace hitscope::physics {
namespace {

/// Vertices that a hull is shown one by one; a target that nothing knocks about has no use for the list.
constexpr std::size_t kMostMoved = 16384;

/// Ericson, Real-Time Collision Detection, 5.3.3: a segment against a box, by separating axes. Divides by
/// nothing, and errs on the side of touching.
bool segmentMeetsBox(const glm::dvec3& start, const glm::dvec3& motion, const Bounds& box, double margin) {
    const glm::dvec3 low(box.min);
    const glm::dvec3 high(box.max);
    const glm::dvec3 half = 0.5 * (high - low) + margin;
    const glm::dvec3 h = 0.5 * motion;
    const glm::dvec3 m = start + h - 0.5 * (low + high);
    glm::dvec3 a = glm::abs(h);
    if (glm::any(glm::greaterThan(glm::abs(m), half + a))) {
        return false;
    }
    a += 1.0e-9 * (a.x + a.y + a.z);
    return std::abs(m.y * h.z - m.z * h.y) <= half.y * a.z + half.z * a.y &&
           std::abs(m.z * h.x - m.x * h.z) <= half.x * a.z + half.z * a.x &&
           std::abs(m.x * h.y - m.y * h.x) <= half.x * a.y + half.y * a.x;
}

/// Balls around boxes and triangles against a sphere that moves up to `fraction` of its motion: once a first
/// contact is known most of a fine surface around it is passed over by this, for a tenth of what the exact
/// cast costs. Errs on the side of touching.
class SweptBall {
public:
    SweptBall(const glm::dvec3& start, const glm::dvec3& motion, double radius)
        : m_start(start), m_motion(motion), m_radius(radius) {
        const double length2 = glm::dot(motion, motion);
        m_perMotion = length2 > 0.0 ? 1.0 / length2 : 0.0;
        m_length = std::sqrt(length2);
        m_ahead = motion * (length2 > 0.0 ? 1.0 / m_length : 0.0);
        const glm::dvec3 farthest = glm::abs(start) + glm::abs(motion);
        m_slack = 1.0e-12 * (farthest.x + farthest.y + farthest.z) + 1.0e-9 * radius;
    }

    /// By how near its nearest corner is ahead, and how far off the way all of it is: on a fine surface the
    /// ball around a triangle is no small thing beside how little later the sphere comes to its neighbours.
    [[nodiscard]] bool mayMeet(const Triangle& triangle, double fraction) const {
        const glm::dvec3 centre = (triangle.a + triangle.b + triangle.c) / 3.0;
        const auto distance2 = [&centre](const glm::dvec3& p) { return glm::dot(p - centre, p - centre); };
        const auto ahead = [this](const glm::dvec3& p) { return glm::dot(p - m_start, m_ahead); };
        const double around =
            std::sqrt(std::max({distance2(triangle.a), distance2(triangle.b), distance2(triangle.c)}));
        const glm::dvec3 from = centre - m_start;
        const double off =
            glm::length(from - m_ahead * glm::dot(from, m_ahead)) * (1.0 - 1.0e-9) - around - m_slack;
        const double reach2 = m_radius * m_radius - (off > 0.0 ? off * off : 0.0);
        if (reach2 < 0.0) {
            return false;
        }
        const double first = std::min({ahead(triangle.a), ahead(triangle.b), ahead(triangle.c)});
        return !(first > m_length * fraction + std::sqrt(reach2) + m_slack);
    }
    [[nodiscard]] bool mayMeet(const Bounds& box, double fraction) const {
        const glm::dvec3 low(box.min);
        const glm::dvec3 half = 0.5 * (glm::dvec3(box.max) - low);
        return mayMeet(low + half, glm::dot(half, half), fraction);
    }

private:
    /// A ball of radius sqrt(around2).
    [[nodiscard]] bool mayMeet(const glm::dvec3& centre, double around2, double fraction) const {
        const glm::dvec3 from = m_start - centre;
        const double nearest = std::clamp(-glm::dot(from, m_motion) * m_perMotion, 0.0, fraction);
        const glm::dvec3 away = from + m_motion * nearest;
        const double reach = m_radius + std::sqrt(around2) * (1.0 + 1.0e-9) + m_slack;
        return !(glm::dot(away, away) > reach * reach);
    }

    glm::dvec3 m_start;
    glm::dvec3 m_motion;
    double m_radius;
    double m_perMotion = 0.0;  ///< 1 / length squared
    double m_length = 0.0;     ///< of the motion, metres
    glm::dvec3 m_ahead;        ///< its direction; 0: none
    double m_slack = 0.0;      ///< metres
};

}  // namespace

MeshSurface::MeshSurface(std::shared_ptr<const CollisionMesh> original)
    : m_original(std::move(original)), m_at(m_original->vertices()), m_tree(m_original->tree()) {}

bool MeshSurface::update(std::uint32_t first, std::span<const DynamicVertex> vertices) {
    if (first > m_at.size() || vertices.size() > m_at.size() - first) {
        return false;
    }
    m_runs.clear();
    for (std::size_t i = 0; i < vertices.size();) {
        const auto begin = first + static_cast<std::uint32_t>(i);
        const std::size_t left = RunPositions::kRun - begin % RunPositions::kRun;
        const std::size_t count = std::min(left, vertices.size() - i);
        if (i + count < vertices.size()) {
            m_at.ask(begin / RunPositions::kRun + 1);
        }
        const Bounds before = moveRun(begin, vertices.subspan(i, count));
        if (!before.empty()) {
            m_runs.push_back({static_cast<std::uint32_t>(begin / RunPositions::kRun), before});
        }
        i += count;
    }
    if (!m_runs.empty()) {
        m_tree.refit(m_at, m_runs);
        findDent();
    }
    return !m_runs.empty();
}

/// Of vertices in one run. Returns where those were that moved; empty: none did.
Bounds MeshSurface::moveRun(std::uint32_t first, std::span<const DynamicVertex> vertices) {
    std::size_t i = 0;
    while (i < vertices.size() && m_at[first + i] == vertices[i].position) {
        ++i;
    }
    Bounds moved;
    if (i == vertices.size()) {
        return moved;
    }
    bool isBack = true;  // those that moved are at their original places
    const std::span<glm::vec3> run = m_at.changeRun(static_cast<std::uint32_t>(first / RunPositions::kRun));
    const std::span<glm::vec3> at = run.subspan(first % RunPositions::kRun, vertices.size());
    for (; i < vertices.size(); ++i) {
        if (at[i] != vertices[i].position) {
            const auto vertex = first + static_cast<std::uint32_t>(i);
            moved.add(at[i]);
            at[i] = vertices[i].position;
            if (m_moved.size() >= kMostMoved) {
                m_movedMany = true;
            } else if (m_tree.uses(vertex)) {  // others are no part of the surface
                m_moved.push_back(vertex);
            }
            // On a fine mesh a look at an original is a cache miss: one that is away is enough.
            if (isBack && isAway(vertex)) {
                isBack = false;
                m_isDented = true;
                m_dent = vertex;
                m_whole = 0;
            }
        }
    }
    return moved;
}

/// If the vertex that was known to be away is back: looks for another one. What it passes is not looked at
/// again before a vertex moves away.
void MeshSurface::findDent() {
    if (!m_isDented || isAway(m_dent)) {
        return;
    }
    for (; m_whole < m_at.changed().size(); ++m_whole) {
        const std::uint32_t run = m_at.changed()[m_whole];
        for (std::uint32_t i = 0; i < m_at.run(run).size(); ++i) {
            m_dent = run * static_cast<std::uint32_t>(RunPositions::kRun) + i;
            if (isAway(m_dent)) {
                return;
            }
        }
    }
    m_at.reset();
    m_isDented = false;
    m_whole = 0;
}

void MeshSurface::reset() {
    if (!isDented()) {
        return;
    }
    m_at.reset();
    m_tree.reset();
    m_isDented = false;
    m_whole = 0;
    m_movedMany = true;
}

void MeshSurface::update(Outermost& hull) {
    const std::vector<std::uint32_t> moved = std::exchange(m_moved, {});
    const bool movedMany = std::exchange(m_movedMany, false);
    if (!isDented()) {
        hull = *m_original->hull();
    } else if (movedMany) {
        hull = Outermost(m_tree, m_at);
    } else {
        hull.follow(m_tree, m_at, moved);
    }
}

Triangle MeshSurface::triangle(std::uint32_t index) const {
    const std::uint32_t* corners = &(*m_original->corners())[std::size_t{3} * index];
    return triangle(TriangleTree::Corners{corners[0], corners[1], corners[2]});
}

std::optional<SurfaceCast> MeshSurface::cast(const glm::dvec3& start, const glm::dvec3& motion,
                                             double radius) const {
    SurfaceCast first;
    const glm::vec3 ahead(motion);
    std::optional<TriangleTree::Visited> met;  // of several at once the one that the tree puts first
    const SweptBall swept(start, motion, radius);
    const auto accept = [&](const Bounds& box) {
        // Nothing comes before the very start.
        return first.fraction > 0.0 && swept.mayMeet(box, first.fraction) &&
               segmentMeetsBox(start, motion * first.fraction, box, radius);
    };
    m_tree.visit(ahead, accept, [&](const TriangleTree::Visited& visited) {
        const Triangle candidate = triangle(visited.corners);
        if (!swept.mayMeet(candidate, first.fraction) || !candidate.hasArea()) {
            return;
        }
        const auto fraction =
            radius > 0.0 ? castSphere(candidate, start, motion, radius) : castPoint(candidate, start, motion);
        if (fraction && (!met || *fraction < first.fraction ||
                         (*fraction == first.fraction && visited.leaf == met->leaf &&
                          m_tree.comesFirst(visited, *met, m_at, ahead)))) {
            first = {*fraction, static_cast<int>(visited.triangle)};
            met = visited;
        }
    });
    return met ? std::optional(first) : std::nullopt;
}

void MeshSurface::visitNear(const glm::vec3& point, float distance,
                            const std::function<void(std::uint32_t, const Triangle&)>& visit) const {
    const auto accept = [&](const Bounds& box) {
        const glm::vec3 away = glm::max(glm::max(box.min - point, point - box.max), glm::vec3(0.0f));
        return glm::dot(away, away) <= distance * distance;
    };
    m_tree.visit(glm::vec3(0.0f), accept, [&](const TriangleTree::Visited& visited) {
        const Triangle candidate = triangle(visited.corners);
        if (candidate.hasArea()) {
            visit(visited.triangle, candidate);
        }
    });
}

void MeshSurface::visitWithin(const Bounds& box,
                              const std::function<void(std::uint32_t, const Triangle&)>& visit) const {
    const auto accept = [&](const Bounds& other) {
        return glm::all(glm::lessThanEqual(other.min, box.max)) &&
               glm::all(glm::lessThanEqual(box.min, other.max));
    };
    m_tree.visit(glm::vec3(0.0f), accept, [&](const TriangleTree::Visited& visited) {
        const Triangle candidate = triangle(visited.corners);
        if (candidate.hasArea()) {
            visit(visited.triangle, candidate);
        }
    });
}

}  // namespace hitscope::physics
