// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

namespace hitscope {

/// One polygon in numbers. Measured as a fan about its first corner; what a concave polygon's fan covers
/// twice counts against itself.
struct FaceMeasure {
    double area = 0.0;       ///< square metres
    glm::dvec3 facing{0.0};  ///< twice the area along the normal, counter-clockwise side
    double volume = 0.0;     ///< cubic metres between the fan and the reference point, signed
    glm::dvec3 moment{0.0};  ///< volume times its centroid, from the reference point
    /// Longest edge times perimeter over area, 1 for a regular polygon and greater for any other (Verdict's
    /// aspect ratio of triangles and quads, and the same for more corners); infinite for a degenerate face.
    double aspect = 0.0;
    bool isDegenerate = false;  ///< no wider than a millionth of its length
};

/// `face` indexes `positions`, at least 3. `reference`: metres, any point near the mesh.
[[nodiscard]] FaceMeasure measureFace(std::span<const glm::vec3> positions,
                                      std::span<const std::uint32_t> face, const glm::dvec3& reference);

}  // namespace hitscope
