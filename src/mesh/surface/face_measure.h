// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "mesh/triangulate.h"

namespace hitscope {

/// One polygon in numbers, those of the triangles it is drawn and exported as.
struct FaceMeasure {
    double area = 0.0;       ///< square metres
    double volume = 0.0;     ///< cubic metres between the triangles and the reference point, signed
    glm::dvec3 moment{0.0};  ///< volume times its centroid, from the reference point
    /// Longest edge times perimeter over area, 1 for a regular polygon and greater for any other (Verdict's
    /// aspect ratio of triangles and quads, and the same for more corners); infinite for a degenerate face.
    double aspect = 0.0;
    bool isDegenerate = false;  ///< no wider than a millionth of its length
};

/// Measures faces whose corners have moved since they were cut into triangles.
class FaceMeasurer {
public:
    /// Where the corners were when the faces were cut. They outlive it.
    explicit FaceMeasurer(std::span<const glm::vec3> originals) : m_originals(originals) {}

    /// `face` indexes `positions`, as many as the originals; at least 3 corners. `reference`: metres, any
    /// point near the mesh.
    [[nodiscard]] FaceMeasure measure(std::span<const glm::vec3> positions,
                                      std::span<const std::uint32_t> face, const glm::dvec3& reference);

private:
    std::span<const glm::vec3> m_originals;
    Triangulator m_triangulator;
    std::vector<std::uint32_t> m_corners;
};

}  // namespace hitscope
