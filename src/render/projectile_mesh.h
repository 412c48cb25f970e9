// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace hitscope::render {

/// A unit sphere about the origin, whose vertices are their own normals.
struct BallMesh {
    std::vector<glm::vec3> vertices;
    std::vector<std::uint16_t> indices;  ///< 3 a triangle
};

/// segments >= 3 around, rings >= 2 from pole to pole.
[[nodiscard]] BallMesh makeBall(int segments, int rings);

}  // namespace hitscope::render
