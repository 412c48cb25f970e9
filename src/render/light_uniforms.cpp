// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "render/frame_context.h"

namespace hitscope::render {
namespace {

void setColours(const gl::Program& program, const std::string& name, const LightColours& colours) {
    program.set(name + ".ambient", colours.ambient);
    program.set(name + ".diffuse", colours.diffuse);
    program.set(name + ".specular", colours.specular);
}

glm::vec3 unitOrDown(const glm::vec3& direction) {
    const float length = glm::length(direction);
    return length > 1.0e-6f ? direction / length : glm::vec3(0.0f, -1.0f, 0.0f);
}

}  // namespace

void setLights(const gl::Program& program, const FrameContext& context) {
    const Lights& lights = context.frame.lights;
    program.set("u_eye", context.eye);
    program.set("u_eyeDirection", context.forward);

    program.set("u_directionalOn", lights.directional.on ? 1 : 0);
    program.set("u_directionalDirection", unitOrDown(lights.directional.direction));
    setColours(program, "u_directionalColours", lights.directional.colours);

    for (std::size_t i = 0; i < lights.points.size(); ++i) {
        const PointLight& light = lights.points[i];
        std::string index = "[0]";
        index[1] = static_cast<char>('0' + i);
        program.set("u_pointOn" + index, light.on ? 1 : 0);
        program.set("u_pointPosition" + index, light.position);
        program.set("u_pointAttenuation" + index, glm::vec3(light.constant, light.linear, light.quadratic));
        setColours(program, "u_pointColours" + index, light.colours);
    }

    program.set("u_spotOn", lights.spot.on ? 1 : 0);
    program.set("u_spotAttenuation",
                glm::vec3(lights.spot.constant, lights.spot.linear, lights.spot.quadratic));
    program.set("u_spotCosines",
                glm::vec2(std::cos(lights.spot.innerAngle), std::cos(lights.spot.outerAngle)));
    setColours(program, "u_spotColours", lights.spot.colours);
}

}  // namespace hitscope::render
