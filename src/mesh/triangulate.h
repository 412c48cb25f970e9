// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace hitscope {

/// Twice the area of a polygon, along its normal (counter-clockwise side): the sum over its fan, so that
/// holes and notches of a flat polygon count as they should. `vertices` index `positions`, at least 3.
[[nodiscard]] glm::dvec3 doubleAreaVector(std::span<const glm::vec3> positions,
                                          std::span<const std::uint32_t> vertices);

/// Cuts polygons into triangles, keeping their orientation. One object serves a whole mesh: it reuses its
/// memory and limits the total work, so that no file can make it run for minutes.
class Triangulator {
public:
    /// Appends n - 2 triangles, three corner numbers in [0, n) each, for the polygon of n = vertices.size()
    /// >= 3 corners. Convex ones become a fan (quads are split on the shorter diagonal), others have their
    /// ears clipped in the polygon's best plane. Degenerate polygons give degenerate triangles.
    void triangulate(std::span<const glm::vec3> positions, std::span<const std::uint32_t> vertices,
                     std::vector<std::uint32_t>& triangles);

    /// Whether all objects together did no more than one alone may: what each made is then what one would
    /// have made of all their polygons.
    [[nodiscard]] static bool areAsOne(std::span<const Triangulator> parts);

private:
    void project(std::span<const glm::vec3> positions, std::span<const std::uint32_t> vertices);
    [[nodiscard]] bool isConvex() const;
    void clipEars(std::vector<std::uint32_t>& triangles);
    [[nodiscard]] bool isEar(std::uint32_t corner);
    [[nodiscard]] bool isReflex(std::uint32_t corner) const;

    std::vector<glm::dvec2> m_points;  ///< the polygon's corners in its plane, counter-clockwise
    std::vector<std::uint32_t> m_next;
    std::vector<std::uint32_t> m_previous;
    std::vector<std::uint32_t>
        m_reflex;  ///< corners that were reflex at the start; the others never become so
    static constexpr std::uint64_t kMostWork = 300'000'000;
    std::uint64_t m_workLeft = kMostWork;  ///< point-in-triangle tests; without any left, fans
};

}  // namespace hitscope
