// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "render/frame_context.h"
#include "render/shadow_map.h"

namespace hitscope::render {
namespace {

constexpr float kFinestCells = 14.0f;     // of the floor's finest squares fit between eye and pivot
constexpr float kCoarsestCells = 100.0f;  // of the finest squares are a side of the coarsest

constexpr int kOpenSamples = 24;
constexpr int kOpenUnit = 5;
constexpr int kLitUnit = 5;
constexpr int kShadedUnit = 6;

void append(gl::Defines& defines, const gl::Defines& more) {
    defines.insert(defines.end(), more.begin(), more.end());
}

void placeFloor(const gl::Program& floor, const FrameContext& context) {
    const Frame& frame = context.frame;
    const glm::vec3 pivot = frame.camera.pivot();
    // Its lines are smooth as they are.
    floor.set("u_viewProjection", context.steadyViewProjection);
    floor.set("u_eye", context.eye);
    floor.set("u_centre", glm::vec3(pivot.x, frame.floorHeight, pivot.z));
    floor.set("u_reach", frame.camera.floorReach());
    if (context.shadows != nullptr) {
        context.shadows->apply(floor);
        const glm::mat4& shadow = context.shadows->matrix();
        floor.set("u_floorShadow",
                  glm::mat3(glm::vec3(shadow[0]), glm::vec3(shadow[2]),
                            frame.floorHeight * glm::vec3(shadow[1]) + glm::vec3(shadow[3])));
    }
}

void bindTexture(const gl::Program& program, const char* name, int unit, GLuint texture) {
    program.set(name, unit);
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindSampler(static_cast<GLuint>(unit), 0);
    glBindTexture(GL_TEXTURE_2D, texture);
    glActiveTexture(GL_TEXTURE0);
}

/// As it looks with no targets around but for these shadows, and what keeps light away. open: a texture, or
/// 0.
Status drawFloorItself(const FrameContext& context, const gl::Defines& shadows, GLuint open = 0) {
    gl::Defines defines = lightDefines(context.frame.lights);
    append(defines, shadows);
    if (open != 0) {
        defines.emplace_back("HITSCOPE_OPEN", "1");
    }
    const auto program = context.programs.get("floor.vert", "floor.frag", defines);
    if (!program) {
        return program.error();
    }
    const gl::Program& floor = *program.value();
    const Frame& frame = context.frame;
    const float height = std::abs(context.eye.y - frame.floorHeight);
    // Squares grow tenfold with the distance, and fade before they do, so that there are never too many.
    const float scale =
        std::log10(std::max(std::max(frame.camera.distance(), height) / kFinestCells, 1.0e-6f));
    floor.use();
    setLights(floor, context);
    placeFloor(floor, context);
    floor.set("u_diffuse", context.colours.floor);
    floor.set("u_lineColour", context.colours.floorLines);
    const float cell = std::pow(10.0f, std::floor(scale));
    const glm::vec3 pivot = frame.camera.pivot();
    floor.set("u_cell", cell);
    floor.set("u_fromLines", glm::mod(glm::vec2(pivot.x, pivot.z), kCoarsestCells * cell));
    floor.set("u_cellFade", scale - std::floor(scale));
    if (open != 0) {
        bindTexture(floor, "u_floorOpen", kOpenUnit, open);
        floor.set("u_perPixel",
                  1.0f / glm::vec2(static_cast<float>(frame.width), static_cast<float>(frame.height)));
    }
    glBindVertexArray(context.emptyArray);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    return Done{};
}

Status drawFloorSample(const FrameContext& context) {
    const gl::Defines defines = context.shadows != nullptr ? context.shadows->defines() : gl::Defines{};
    const auto program = context.programs.get("floor.vert", "floor_sample.frag", defines);
    if (!program) {
        return program.error();
    }
    const gl::Program& floor = *program.value();
    floor.use();
    placeFloor(floor, context);
    bindTexture(floor, "u_floorLit", kLitUnit, context.floorLayers->lit);
    bindTexture(floor, "u_floorShaded", kShadedUnit, context.floorLayers->shaded);
    glBindVertexArray(context.emptyArray);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    return Done{};
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
    if (context.floorLayers != nullptr) {
        return drawFloorSample(context);
    }
    return drawFloorItself(context, context.shadows != nullptr ? context.shadows->defines() : gl::Defines{});
}

Status drawFloorOpen(const FrameContext& given, const glm::ivec2& size) {
    FrameContext context = given;
    context.shadows = nullptr;
    gl::Defines defines = occlusionDefines(context);
    addSight(defines, context.frame);
    const auto program = context.programs.get("floor.vert", "floor_open.frag", defines);
    if (!program) {
        return program.error();
    }
    const gl::Program& open = *program.value();
    open.use();
    placeFloor(open, context);
    setOcclusion(open, context, glm::vec2(0.0f));
    open.set("u_samples", kOpenSamples);
    open.set("u_pixels", glm::vec2(context.frame.width, context.frame.height) / glm::vec2(size));
    glBindVertexArray(context.emptyArray);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    return Done{};
}

Status drawFloorLayer(const FrameContext& given, bool isShaded, GLuint open) {
    FrameContext context = given;
    context.shadows = nullptr;
    return drawFloorItself(context, isShaded ? gl::Defines{{"HITSCOPE_SHADED", "1"}} : gl::Defines{}, open);
}

}  // namespace hitscope::render
