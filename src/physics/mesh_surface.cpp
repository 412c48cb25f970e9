// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/mesh_surface.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <utility>

namespace hitscope::physics {
namespace {

/// How many regions around moved runs about take in a place of the surface.
constexpr std::size_t kOverlap = 4;
constexpr std::size_t kACacheLine = 5;  // positions
/// Vertices that a hull is shown one by one; a target that nothing knocks about has no use for the list.
constexpr std::size_t kMostMoved = 16384;

/// Makes one region of two that are next to each other: the tree is gone through once for both.
bool joins(Bounds& region, const Bounds& other) {
    Bounds both = region;
    both.add(other);
    if (both.diagonal() > region.diagonal() + other.diagonal()) {
        return false;
    }
    region = both;
    return true;
}

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
    : m_original(std::move(original)), m_tree(m_original->tree()) {}

/// Large meshes take much memory: a surface has vertices of its own from its first dent on.
void MeshSurface::makeOwn() {
    if (m_vertices.empty()) {
        m_vertices = m_original->vertices();
        m_isAway.assign(m_vertices.size(), 0);
    }
}

void MeshSurface::update(std::uint32_t first, std::span<const DynamicVertex> vertices) {
    makeOwn();
    if (first > m_vertices.size() || vertices.size() > m_vertices.size() - first) {
        return;
    }
    // Neighbours in the buffer are neighbours in space, but only within a run of this length: a region over
    // several dents would take in all that lies between them.
    std::vector<Bounds> regions;
    for (std::size_t i = 0; i < vertices.size(); i += kClusterVertices) {
        const std::size_t count = std::min<std::size_t>(kClusterVertices, vertices.size() - i);
        const Bounds moved = moveRun(first + static_cast<std::uint32_t>(i), vertices.subspan(i, count));
        if (!moved.empty() && (regions.empty() || !joins(regions.back(), moved))) {
            regions.push_back(moved);
        }
    }
    // Regions of neighbours overlap: where much of the mesh moved, going through it once is less.
    if (regions.size() * kClusterVertices * kOverlap > m_vertices.size()) {
        Bounds all;
        for (const Bounds& region : regions) {
            all.add(region);
        }
        regions.assign(1, all);
    }
    for (const Bounds& region : regions) {
        m_tree.refit(m_vertices, region);
    }
}

/// Returns where the vertices were that moved; empty: none did.
Bounds MeshSurface::moveRun(std::uint32_t first, std::span<const DynamicVertex> vertices) {
    const std::vector<glm::vec3>& original = m_original->vertices();
    Bounds moved;
    // On a fine mesh each is a cache miss; asked for together, the memory works on them at once.
    for (std::size_t i = 0; i < vertices.size(); i += kACacheLine) {
        __builtin_prefetch(&m_vertices[first + i], 1);
        __builtin_prefetch(&original[first + i]);
    }
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        glm::vec3& vertex = m_vertices[first + i];
        const glm::vec3& position = vertices[i].position;
        if (vertex != position) {
            moved.add(vertex);
            // What moves for the first time leaves its place: on a fine mesh a look at it is a cache miss.
            const bool isAway = m_isAway[first + i] == 0 || position != original[first + i];
            m_away += isAway ? 1u : 0u;
            m_away -= m_isAway[first + i];
            m_isAway[first + i] = isAway ? 1 : 0;
            vertex = position;
            m_movedMany = m_movedMany || m_moved.size() == kMostMoved;
            if (!m_movedMany) {
                m_moved.push_back(first + static_cast<std::uint32_t>(i));
            }
        }
    }
    return moved;
}

void MeshSurface::reset() {
    if (isDented()) {
        m_vertices = m_original->vertices();
        m_tree = m_original->tree();
        m_tree.makeOwn();  // the next dent is not to wait for it
        m_isAway.assign(m_vertices.size(), 0);
        m_away = 0;
        m_movedMany = true;
    }
}

void MeshSurface::update(Outermost& hull) {
    const std::vector<std::uint32_t> moved = std::exchange(m_moved, {});
    const bool movedMany = std::exchange(m_movedMany, false);
    if (!isDented()) {
        hull = *m_original->hull();
    } else if (movedMany) {
        hull = Outermost(m_tree, vertices(), *m_original->corners());
    } else {
        hull.follow(m_tree, vertices(), *m_original->corners(), moved);
    }
}

Triangle MeshSurface::triangle(std::uint32_t index) const {
    const std::uint32_t* corners = &(*m_original->corners())[std::size_t{3} * index];
    const std::vector<glm::vec3>& at = vertices();
    return {at[corners[0]], at[corners[1]], at[corners[2]]};
}

std::optional<SurfaceCast> MeshSurface::cast(const glm::dvec3& start, const glm::dvec3& motion,
                                             double radius) const {
    SurfaceCast first;
    bool found = false;
    const SweptBall swept(start, motion, radius);
    const auto accept = [&](const Bounds& box) {
        // Nothing comes before the very start.
        return first.fraction > 0.0 && swept.mayMeet(box, first.fraction) &&
               segmentMeetsBox(start, motion * first.fraction, box, radius);
    };
    m_tree.visit(glm::vec3(motion), accept, [&](std::uint32_t index) {
        const Triangle candidate = triangle(index);
        if (!swept.mayMeet(candidate, first.fraction) || !candidate.hasArea()) {
            return;
        }
        const auto fraction =
            radius > 0.0 ? castSphere(candidate, start, motion, radius) : castPoint(candidate, start, motion);
        if (fraction && (!found || *fraction < first.fraction)) {
            first = {*fraction, static_cast<int>(index)};
            found = true;
        }
    });
    return found ? std::optional(first) : std::nullopt;
}

void MeshSurface::visitNear(const glm::vec3& point, float distance,
                            const std::function<void(std::uint32_t, const Triangle&)>& visit) const {
    const auto accept = [&](const Bounds& box) {
        const glm::vec3 away = glm::max(glm::max(box.min - point, point - box.max), glm::vec3(0.0f));
        return glm::dot(away, away) <= distance * distance;
    };
    m_tree.visit(glm::vec3(0.0f), accept, [&](std::uint32_t index) {
        const Triangle candidate = triangle(index);
        if (candidate.hasArea()) {
            visit(index, candidate);
        }
    });
}

void MeshSurface::visitWithin(const Bounds& box,
                              const std::function<void(std::uint32_t, const Triangle&)>& visit) const {
    const auto accept = [&](const Bounds& other) {
        return glm::all(glm::lessThanEqual(other.min, box.max)) &&
               glm::all(glm::lessThanEqual(box.min, other.max));
    };
    m_tree.visit(glm::vec3(0.0f), accept, [&](std::uint32_t index) {
        const Triangle candidate = triangle(index);
        if (candidate.hasArea()) {
            visit(index, candidate);
        }
    });
}

}  // namespace hitscope::physics
