// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "render/frame_context.h"
#include "render/shadow_map.h"

namespace hitscope::render {
namespace {

constexpr float kFinestCells = 14.0f;  // of the floor's finest squares fit between eye and pivot

gl::Defines floorDefines(const FrameContext& context) {
    gl::Defines defines = lightDefines(context.frame.lights);
    if (context.shadows != nullptr) {
        const gl::Defines shadows = context.shadows->defines();
        defines.insert(defines.end(), shadows.begin(), shadows.end());
    }
    const gl::Defines occlusion = occlusionDefines(context);
    defines.insert(defines.end(), occlusion.begin(), occlusion.end());
    return defines;
}

}  // namespace

Status drawBackground(const FrameContext& context) {
    if (context.frame.options.transparent) {
        return Done{};
    }
    const auto program = context.programs.get("background.vert", "background.frag");
    if (!program) {
        return program.error();
    }
    const gl::Program& background = *program.value();
    background.use();
    background.set("u_top", context.colours.backgroundTop);
    background.set("u_bottom", context.colours.backgroundBottom);
    background.set("u_left", static_cast<float>(context.frame.left));
    glBindVertexArray(context.emptyArray);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    return Done{};
}

Status drawFloor(const FrameContext& context) {
    const auto program = context.programs.get("floor.vert", "floor.frag", floorDefines(context));
    if (!program) {
        return program.error();
    }
    const gl::Program& floor = *program.value();
    const Frame& frame = context.frame;
    const glm::vec3 pivot = frame.camera.pivot();
    const float height = std::abs(context.eye.y - frame.floorHeight);
    // Squares grow tenfold with the distance, and fade before they do, so that there are never too many.
    const float scale =
        std::log10(std::max(std::max(frame.camera.distance(), height) / kFinestCells, 1.0e-6f));
    floor.use();
    setLights(floor, context);
    setOcclusion(floor, context);
    floor.set("u_viewProjection", context.viewProjection);
    floor.set("u_eye", context.eye);
    floor.set("u_centre", glm::vec3(pivot.x, frame.floorHeight, pivot.z));
    floor.set("u_reach", frame.camera.floorReach());
    floor.set("u_diffuse", context.colours.floor);
    floor.set("u_lineColour", context.colours.floorLines);
    floor.set("u_cell", std::pow(10.0f, std::floor(scale)));
    floor.set("u_cellFade", scale - std::floor(scale));
    if (context.shadows != nullptr) {
        context.shadows->apply(floor);
        const glm::mat4& shadow = context.shadows->matrix();
        floor.set("u_floorShadow",
                  glm::mat3(glm::vec3(shadow[0]), glm::vec3(shadow[2]),
                            frame.floorHeight * glm::vec3(shadow[1]) + glm::vec3(shadow[3])));
    }
    glBindVertexArray(context.emptyArray);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    return Done{};
}

}  // namespace hitscope::render
