// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/vec3.hpp>

namespace hitscope {

/// Ambient, diffuse and specular terms of a light (paper, eq. 7): one colour, and how strong it is in each.
struct LightTerms {
    glm::vec3 colour{1.0f};  ///< linear RGB, [0, 1]
    float ambient = 0.05f;   ///< all strengths: >= 0
    float diffuse = 0.8f;
    float specular = 0.5f;

    bool operator==(const LightTerms&) const = default;
};

/// 1 / (constant + linear d + quadratic d^2) of the light is left (eq. 12) at a distance of d metres (eq.
/// 13).
struct Attenuation {
    float constant = 1.0f;   ///< > 0
    float linear = 0.0f;     ///< 1/m, >= 0
    float quadratic = 0.0f;  ///< 1/m^2, >= 0

    bool operator==(const Attenuation&) const = default;
};

struct DirectionalLight {
    bool on = true;
    glm::vec3 direction{0.5f, -0.8f, -0.45f};  ///< the way the light travels, world
    LightTerms terms;

    bool operator==(const DirectionalLight&) const = default;
};

struct PointLight {
    bool on = true;
    glm::vec3 position{0.0f};  ///< metres, world
    Attenuation attenuation{1.0f, 0.09f, 0.032f};
    LightTerms terms;

    bool operator==(const PointLight&) const = default;
};

/// A point light within a cone with a smooth edge (eq. 14).
struct SpotLight {
    bool on = true;
    bool atEye = true;                       ///< looking along the view; else position and direction count
    glm::vec3 position{0.0f};                ///< metres, world
    glm::vec3 direction{0.0f, -1.0f, 0.0f};  ///< the way the light travels, world
    float innerAngle = 0.2181662f;           ///< radians from the axis, full intensity inside
    float outerAngle = 0.3054326f;           ///< radians from the axis, dark outside; above innerAngle
    Attenuation attenuation{1.0f, 0.045f, 0.0075f};
    LightTerms terms;

    bool operator==(const SpotLight&) const = default;
};

/// The paper's lights (section 2.5, reference scene): one directional, four point lights, a spotlight at the
/// eye.
struct Lights {
    DirectionalLight directional;
    std::array<PointLight, 4> points;
    SpotLight spot;

    bool operator==(const Lights&) const = default;
};

/// What lights are placed around.
struct LightSpace {
    glm::vec3 centre{0.0f};  ///< metres, world
    float extent = 1.0f;     ///< metres: the longest side of the scene's box; >= 0
};

/// The point lights stand above the scene's corners.
[[nodiscard]] Lights defaultLights(const LightSpace& space);
/// As they stood in `from`, in `to`: places relative to the scene, and as much light left there.
[[nodiscard]] Lights moved(const Lights& lights, const LightSpace& from, const LightSpace& to);

}  // namespace hitscope
