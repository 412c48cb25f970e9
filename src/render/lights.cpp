// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/lights.h"

#include <algorithm>

namespace hitscope {

Lights defaultLights(const glm::vec3& centre, float extent) {
    Lights lights;
    const float size = std::max(extent, 1.0e-3f);

    lights.directional.colours.ambient = glm::vec3(0.085f, 0.09f, 0.1f);
    lights.directional.colours.diffuse = glm::vec3(1.05f, 1.0f, 0.93f);
    lights.directional.colours.specular = glm::vec3(0.35f);

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
        light.constant = 1.0f;
        light.linear = 0.35f / reach;
        light.quadratic = 0.65f / (reach * reach);
        const glm::vec3 tint = x * z > 0.0f ? warm : cool;
        light.colours.ambient = 0.015f * tint;
        light.colours.diffuse = 0.25f * tint;
        light.colours.specular = 0.14f * tint;
    }

    lights.spot.constant = 1.0f;
    lights.spot.linear = 0.1f / size;
    lights.spot.quadratic = 0.25f / (size * size);
    lights.spot.colours.ambient = glm::vec3(0.0f);
    lights.spot.colours.diffuse = glm::vec3(0.1f, 0.0975f, 0.0925f);
    lights.spot.colours.specular = glm::vec3(0.12f);
    return lights;
}

}  // namespace hitscope
