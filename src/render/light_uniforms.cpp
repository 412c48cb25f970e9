// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "render/frame_context.h"

namespace hitscope::render {
namespace {

constexpr float kLeastConstant = 1.0e-3f;  // of the attenuation
constexpr float kLeastConeEdge = 1.0e-4f;  // difference of cosines from a spotlight's full light to none

glm::vec3 unitOrDown(const glm::vec3& direction) {
    const float length = glm::length(direction);
    return length > 1.0e-6f ? direction / length : glm::vec3(0.0f, -1.0f, 0.0f);
}

glm::vec3 strengths(const LightTerms& terms) {
    return {terms.ambient, terms.diffuse, terms.specular};
}

/// The whole of equation 12 over its constant factor: what is left of it, and the colour that goes with that.
struct Attenuated {
    glm::vec2 factors;
    glm::vec3 colour;
};

Attenuated attenuated(const Attenuation& attenuation, const glm::vec3& colour) {
    const float constant = std::max(attenuation.constant, kLeastConstant);
    return {glm::vec2(attenuation.linear, attenuation.quadratic) / constant, colour / constant};
}

void setDirectional(const gl::Program& program, const DirectionalLight& light) {
    program.set("u_directionalDirection", -unitOrDown(light.direction));
    program.set("u_directionalColour", light.terms.colour);
    program.set("u_directionalStrengths", strengths(light.terms));
}

void setPoint(const gl::Program& program, const glm::vec3& eye, const PointLight& light, std::size_t place) {
    std::string index = "[0]";
    index[1] = static_cast<char>('0' + place);
    const Attenuated shone = attenuated(light.attenuation, light.terms.colour);
    program.set("u_pointPosition" + index, light.position - eye);
    program.set("u_pointAttenuation" + index, shone.factors);
    program.set("u_pointColour" + index, shone.colour);
    program.set("u_pointStrengths" + index, strengths(light.terms));
}

void setSpot(const gl::Program& program, const FrameContext& context, const SpotLight& light) {
    const Attenuated shone = attenuated(light.attenuation, light.terms.colour);
    const float outer = std::cos(light.outerAngle);
    const float edge = std::max(std::cos(light.innerAngle) - outer, kLeastConeEdge);
    program.set("u_spotPosition", light.position - context.eye);
    program.set("u_spotDirection", light.atEye ? -context.forward : -unitOrDown(light.direction));
    program.set("u_spotAttenuation", shone.factors);
    program.set("u_spotCone", glm::vec2(outer, 1.0f / edge));
    program.set("u_spotColour", shone.colour);
    program.set("u_spotStrengths", strengths(light.terms));
}

/// Those that are on differ in place and colour at most.
bool areAlike(const std::array<PointLight, 4>& lights) {
    const auto isOn = [](const PointLight& light) { return light.on; };
    const auto first = std::find_if(lights.begin(), lights.end(), isOn);
    return std::all_of(lights.begin(), lights.end(), [&](const PointLight& light) {
        return !light.on || (strengths(light.terms) == strengths(first->terms) &&
                             attenuated(light.attenuation, glm::vec3(0.0f)).factors ==
                                 attenuated(first->attenuation, glm::vec3(0.0f)).factors);
    });
}

}  // namespace

void addSight(gl::Defines& defines, const Frame& frame) {
    if (frame.camera.isOrthographic()) {
        defines.emplace_back("HITSCOPE_ORTHOGRAPHIC", "1");
    }
}

void setSight(const gl::Program& program, const Frame& frame) {
    if (frame.camera.isOrthographic()) {
        program.set("u_lookAlong", frame.camera.forward());
    }
}

gl::Defines lightDefines(const Lights& lights) {
    gl::Defines defines;
    defines.reserve(4);
    if (lights.directional.on) {
        defines.emplace_back("HITSCOPE_DIRECTIONAL", "1");
    }
    const auto points = std::count_if(lights.points.begin(), lights.points.end(),
                                      [](const PointLight& light) { return light.on; });
    if (points > 0) {
        defines.emplace_back("HITSCOPE_POINTS", std::to_string(points));
        if (points > 1 && areAlike(lights.points)) {
            defines.emplace_back("HITSCOPE_POINTS_ALIKE", "1");
        }
    }
    if (lights.spot.on) {
        defines.emplace_back("HITSCOPE_SPOT", lights.spot.atEye ? "1" : "2");
    }
    return defines;
}

void setLights(const gl::Program& program, const FrameContext& context) {
    const Lights& lights = context.frame.lights;
    if (lights.directional.on) {
        setDirectional(program, lights.directional);
    }
    std::size_t place = 0;
    for (const PointLight& light : lights.points) {
        if (light.on) {
            setPoint(program, context.eye, light, place++);
        }
    }
    if (lights.spot.on) {
        setSpot(program, context, lights.spot);
    }
}

}  // namespace hitscope::render
