// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render/frame_context.h"

namespace hitscope::render {
namespace {

constexpr float kRingOpacity = 0.9f;
constexpr float kSelectionRing = 1.6f;    // logical pixels
constexpr float kCrosshairReach = 13.0f;  // logical pixels, with a margin around the arms
constexpr float kRingMargin = 8.0f;       // pixels around the outline for its width

/// How a sphere is seen.
struct Outline {
    float radius = 0.0f;    ///< metres, around its centre; 0: it is not seen from outside
    glm::vec3 ahead{0.0f};  ///< unit, the way one looks at its centre
    float pixel = 0.0f;     ///< metres that a pixel takes there
};

Outline outlineOf(const Sphere& sphere, const FrameContext& context) {
    if (context.frame.camera.isOrthographic()) {
        return {sphere.radius, context.forward, 1.0f / context.pixelsAtOneMetre};
    }
    const glm::vec3 away = sphere.centre - context.eye;
    const float distance = glm::length(away);
    if (distance <= sphere.radius || glm::dot(away, context.forward) <= 0.0f) {
        return {};  // the eye is within it, or it lies behind
    }
    // It is wider than the section through the centre: the tangents meet the sphere in front of that.
    const float ratio = sphere.radius / distance;
    return {sphere.radius / std::sqrt(1.0f - ratio * ratio), away / distance,
            distance / context.pixelsAtOneMetre};
}

}  // namespace

Status drawHighlightedHit(const FrameContext& context) {
    const Frame& frame = context.frame;
    if (!frame.highlightedHit || frame.highlightedHit->radius <= 0.0f) {
        return Done{};
    }
    const Sphere& hit = *frame.highlightedHit;
    const Outline outline = outlineOf(hit, context);
    if (outline.radius <= 0.0f) {
        return Done{};
    }
    const auto program = context.programs.get("ring.vert", "ring.frag");
    if (!program) {
        return program.error();
    }
    const glm::vec3 right = glm::normalize(glm::cross(outline.ahead, frame.camera.up()));
    const glm::vec3 up = glm::cross(right, outline.ahead);
    const float half = outline.radius + kRingMargin * frame.pixelRatio * outline.pixel;
    const gl::Program& ring = *program.value();
    ring.use();
    ring.set("u_viewProjection", context.viewProjection);
    ring.set("u_centre", hit.centre);
    ring.set("u_right", right * half);
    ring.set("u_up", up * half);
    ring.set("u_radius", outline.radius / half);
    ring.set("u_width", std::max(1.0f, kSelectionRing * frame.pixelRatio));
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
