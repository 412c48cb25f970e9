// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "view/camera.h"

namespace hitscope::render {

/// A unit sphere about the origin, whose vertices are their own normals.
struct BallMesh {
    std::vector<glm::vec3> vertices;
    std::vector<std::uint16_t> indices;  ///< 3 a triangle
};

/// The geodesic sphere of this frequency, 1 to 80.
[[nodiscard]] BallMesh makeBall(int frequency);

/// The radius, metres, to draw a projectile of `radius` with whose centre is there: nothing at the eye, from
/// where it is shot and where it would hide the picture, and more until it is itself, half way to the
/// camera's pivot. It never takes more than a seventh of the picture on the way.
[[nodiscard]] float drawnRadius(const Camera& camera, const glm::vec3& centre, float radius);

}  // namespace hitscope::render
