// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "mesh/section.h"

namespace hitscope {

/// What a dent amounts to: metres, square and cubic metres, in the target's local frame.
struct DentMeasures {
    std::size_t vertices = 0;   ///< that it moved
    std::uint32_t deepest = 0;  ///< of them, the one furthest below where it was, in the midst of a flat
                                ///< bottom; if none went below, the one that moved farthest
    /// Unit, into the surface: against its mean normal before, or, where its normals point all over, as on
    /// both sides of a thin limb, the way that its vertices moved on average.
    glm::vec3 axis{0.0f};
    double depth = 0.0;            ///< of the deepest, along `axis`
    double rimDiameter = 0.0;      ///< greatest distance across, at right angles to `axis`, before
    double affectedArea = 0.0;     ///< a third of each triangle for each of its corners that moved, before
    double displacedVolume = 0.0;  ///< between the surface before and after, inwards positive
};

/// The vertices around `seed` that have moved: it and what can be reached from it along edges of triangles
/// through vertices that are elsewhere in `after` than in `before`. Ascending; empty if the seed has not
/// moved. The triangles (three indices each), `before` and `after` are of the file's vertices. `sewn`: which
/// vertex stands for each where the file split the surface (sewnVertices()); empty: each for itself.
[[nodiscard]] std::vector<std::uint32_t> dentAround(std::uint32_t seed,
                                                    std::span<const std::uint32_t> triangles,
                                                    std::span<const glm::vec3> before,
                                                    std::span<const glm::vec3> after,
                                                    std::span<const std::uint32_t> sewn = {});

/// Measures what happened to `vertices` (ascending). The volume is what the triangles sweep on their straight
/// way from before to after, which for a whole dent that does not reach the surface's boundary is exactly
/// what lies between the two. Nothing when there are none, or no triangle has them. Where a
/// body's faces point inwards and the dent is pushed that way, they count as if they were turned.
///
/// Of a part of a dent, `whole` is all of it (ascending): triangles at the border count for each part by the
/// corners they have there, so that areas and volumes of the parts add up to those of the whole.
[[nodiscard]] std::optional<DentMeasures> measureDent(std::span<const std::uint32_t> vertices,
                                                      std::span<const std::uint32_t> triangles,
                                                      std::span<const glm::vec3> before,
                                                      std::span<const glm::vec3> after,
                                                      std::span<const std::uint32_t> whole = {});

/// The plane through a dent's deepest vertex, where it was, and its axis; `angle` radians about the axis from
/// a direction that is level where the axis is not upright (and along x there).
[[nodiscard]] Plane profilePlane(const DentMeasures& dent, const glm::vec3& deepestBefore, float angle);

/// Where in a profile a point of the plane lies, metres: along the surface from the axis, and along the axis
/// out of the surface.
struct ProfilePoint {
    double along = 0.0;
    double height = 0.0;
};
[[nodiscard]] ProfilePoint toProfile(const Plane& plane, const DentMeasures& dent,
                                     const glm::vec3& deepestBefore, const glm::vec3& point);

}  // namespace hitscope
