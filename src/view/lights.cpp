// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/lights.h"

#include <algorithm>

namespace hitscope {

namespace {

float sizeOf(const LightSpace& space) {
    return std::max(space.extent, 1.0e-6f);
}

}  // namespace

Lights defaultLights(const LightSpace& space) {
    Lights lights;
    const glm::vec3& centre = space.centre;
    const float size = sizeOf(space);

    lights.directional.terms = {{1.0f, 0.96f, 0.9f}, 0.095f, 1.05f, 0.36f};

    // Warm and cool corners by turns, so that the shape reads from every side.
    const glm::vec3 warm(1.0f, 0.86f, 0.7f);
    const glm::vec3 cool(0.72f, 0.85f, 1.0f);
    const float reach = 0.5f * size;  // metres: about from a light down to the scene
    for (std::size_t i = 0; i < lights.points.size(); ++i) {
        PointLight& light = lights.points[i];
        const float x = (i & 1u) != 0 ? 0.5f : -0.5f;
        const float z = (i & 2u) != 0 ? 0.5f : -0.5f;
        light.position = centre + size * glm::vec3(x, 0.45f, z);
        // Half the light is left at `reach`, whatever the scene's size.
        light.attenuation = {1.0f, 0.35f / reach, 0.65f / (reach * reach)};
        light.terms = {x * z > 0.0f ? warm : cool, 0.015f, 0.25f, 0.14f};
    }

    // Where it goes when it leaves the eye: above the scene, looking down on it.
    lights.spot.position = centre + size * glm::vec3(0.0f, 0.9f, 0.35f);
    lights.spot.direction = centre - lights.spot.position;
    lights.spot.attenuation = {1.0f, 0.1f / size, 0.25f / (size * size)};
    lights.spot.terms = {{1.0f, 0.975f, 0.925f}, 0.0f, 0.1f, 0.12f};
    return lights;
}

Lights moved(const Lights& lights, const LightSpace& from, const LightSpace& to) {
    const float scale = sizeOf(to) / sizeOf(from);
    const auto move = [&](auto& light) {
        light.position = to.centre + scale * (light.position - from.centre);
        light.attenuation.linear /= scale;
        light.attenuation.quadratic /= scale * scale;
    };
    Lights placed = lights;
    std::for_each(placed.points.begin(), placed.points.end(), move);
    move(placed.spot);
    return placed;
}

}  // namespace hitscope
