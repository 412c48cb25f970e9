// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render/frame_context.h"

namespace hitscope::render {
namespace {

constexpr float kRingOpacity = 0.9f;
constexpr float kRingWidth = 1.6f;        // logical pixels
constexpr float kCrosshairReach = 13.0f;  // logical pixels, with a margin around the arms
constexpr float kRingMargin = 8.0f;       // pixels around the outline for its width

}  // namespace

Status drawHighlightedHit(const FrameContext& context) {
    const Frame& frame = context.frame;
    if (!frame.highlightedHit || frame.highlightedHit->radius <= 0.0f) {
        return Done{};
    }
    const Sphere& hit = *frame.highlightedHit;
    const glm::vec3 toHit = hit.centre - context.eye;
    const float distance = glm::length(toHit);
    if (distance <= hit.radius || glm::dot(toHit, context.forward) <= 0.0f) {
        return Done{};  // the eye is within it, or it lies behind
    }
    const auto program = context.programs.get("ring.vert", "ring.frag");
    if (!program) {
        return program.error();
    }
    // A sphere's outline is wider than its section through the centre: the tangents meet it in front of that.
    const glm::vec3 ahead = toHit / distance;
    const glm::vec3 right = glm::normalize(glm::cross(ahead, frame.camera.up()));
    const glm::vec3 up = glm::cross(right, ahead);
    const float outline = hit.radius / std::sqrt(1.0f - (hit.radius / distance) * (hit.radius / distance));
    const float half = outline + kRingMargin * frame.pixelRatio * distance / context.pixelsAtOneMetre;
    const gl::Program& ring = *program.value();
    ring.use();
    ring.set("u_viewProjection", context.viewProjection);
    ring.set("u_centre", hit.centre);
    ring.set("u_right", right * half);
    ring.set("u_up", up * half);
    ring.set("u_radius", outline / half);
    ring.set("u_width", std::max(1.0f, kRingWidth * frame.pixelRatio));
    ring.set("u_colour", glm::vec4(context.colours.accent, kRingOpacity));
    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(context.emptyArray);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glEnable(GL_DEPTH_TEST);
    return Done{};
}

Status drawCrosshair(const FrameContext& context) {
    const Frame& frame = context.frame;
    if (!frame.options.crosshair) {
        return Done{};
    }
    const auto program = context.programs.get("crosshair.vert", "crosshair.frag");
    if (!program) {
        return program.error();
    }
    const float pixels = kCrosshairReach * frame.pixelRatio;
    const gl::Program& crosshair = *program.value();
    crosshair.use();
    crosshair.set("u_pixels", pixels);
    crosshair.set("u_pixelRatio", frame.pixelRatio);
    crosshair.set("u_reach", 2.0f * pixels / glm::vec2(frame.width, frame.height));
    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(context.emptyArray);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glEnable(GL_DEPTH_TEST);
    return Done{};
}

}  // namespace hitscope::render
