// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/vec3.hpp>

namespace hitscope {

/// Ambient, diffuse and specular terms of a light (paper, eq. 7), linear RGB.
struct LightColours {
    glm::vec3 ambient{0.05f};
    glm::vec3 diffuse{0.8f};
    glm::vec3 specular{0.5f};
};

struct DirectionalLight {
    bool on = true;
    glm::vec3 direction{0.5f, -0.8f, -0.45f};  ///< the way the light travels, world
    LightColours colours;
};

/// Attenuated by 1 / (constant + linear d + quadratic d^2) (eq. 12), d in metres (eq. 13).
struct PointLight {
    bool on = true;
    glm::vec3 position{0.0f};  ///< metres, world
    float constant = 1.0f;
    float linear = 0.09f;
    float quadratic = 0.032f;
    LightColours colours;
};

/// A point light within a cone with a smooth edge (eq. 14); at the eye, looking along the view.
struct SpotLight {
    bool on = true;
    float innerAngle = 0.2181662f;  ///< radians from the axis, full intensity inside
    float outerAngle = 0.3054326f;  ///< radians from the axis, dark outside
    float constant = 1.0f;
    float linear = 0.045f;
    float quadratic = 0.0075f;
    LightColours colours;
};

/// The paper's lights (section 2.5, reference scene): one directional, four point lights, a spotlight at the
/// eye.
struct Lights {
    DirectionalLight directional;
    std::array<PointLight, 4> points;
    SpotLight spot;
};

/// Placed for a scene of the given centre and extent (metres): the point lights above its corners.
[[nodiscard]] Lights defaultLights(const glm::vec3& centre, float extent);

}  // namespace hitscope
