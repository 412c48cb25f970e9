// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "core/image.h"
#include "view/lights.h"

namespace hitscope {

/// A studio around the scene: a sky, a ground and three soft lights. It is computed, so that there is no file
/// of it. World axes, y up; all colours linear RGB.

/// What arrives from a direction (unit), blurred as a surface of that roughness, [0, 1], reflects it.
[[nodiscard]] glm::vec3 environmentLight(const glm::vec3& direction, float roughness);
/// What a white matte surface with that normal (unit) sends back: the light around it, weighted by the
/// cosine. By spherical harmonics of order 2: R. Ramamoorthi and P. Hanrahan, "An efficient representation
/// for irradiance environment maps", SIGGRAPH 2001.
[[nodiscard]] glm::vec3 environmentDiffuse(const glm::vec3& normal);
/// The way the brightest light travels, unit.
[[nodiscard]] glm::vec3 environmentKeyDirection();

/// Lights that are much like it, for what is drawn by the lights alone: the floor and projectiles.
[[nodiscard]] Lights environmentLights();

/// The same as a table for shaders: square maps of all directions one above another. The first has what matte
/// surfaces send back, the others what is reflected, of roughness 0 to 1. Each is an octahedral map (y: the
/// pole) of kInner x kInner texels with a border of one texel that continues it, so that texels can be
/// interpolated.
struct EnvironmentTable {
    static constexpr int kInner = 32;
    static constexpr int kSide = kInner + 2;
    static constexpr int kRoughnesses = 6;
    static constexpr int kLayers = 1 + kRoughnesses;
    std::vector<glm::vec3> texels;  ///< kLayers x kSide rows x kSide
};
[[nodiscard]] EnvironmentTable makeEnvironmentTable();

/// A ball of a warm grey material in that studio, seen from the front: the colour for each normal, sRGB.
/// Beyond the ball's edge the edge's colours go on. side: pixels, >= 1.
[[nodiscard]] Image makeMatcap(int side);

}  // namespace hitscope
