// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <glm/geometric.hpp>

#include "render/frame_context.h"

namespace hitscope::render {
namespace {

constexpr float kBesideShadows = 0.45f;  // strength, where there are real ones too
constexpr float kShadeSpread = 1.45f;    // of the target's half size

}  // namespace

glm::vec3 alongView(const FrameContext& context, const DrawItem& item) {
    return glm::transpose(glm::mat3(item.model)) * context.forward;
}

Bounds worldBounds(const DrawItem& item) {
    const Bounds& local = item.buffers->originalBounds();
    Bounds bounds;
    if (local.empty()) {
        return bounds;
    }
    const glm::mat3 rotation(item.model);
    const glm::vec3 half = 0.5f * local.size();
    const glm::vec3 reach =
        glm::abs(rotation[0]) * half.x + glm::abs(rotation[1]) * half.y + glm::abs(rotation[2]) * half.z;
    const glm::vec3 centre = item.model * glm::vec4(local.centre(), 1.0f);
    bounds.add(centre - reach);
    bounds.add(centre + reach);
    return bounds;
}

Status drawContactShades(const FrameContext& context) {
    const Frame& frame = context.frame;
    if (context.eye.y < frame.floorHeight) {
        return Done{};
    }
    const auto program = context.programs.get("contact.vert", "contact.frag");
    if (!program) {
        return program.error();
    }
    const gl::Program& contact = *program.value();
    contact.use();
    contact.set("u_viewProjection", context.steadyViewProjection);
    const float strength =
        context.colours.contactShade * (context.shadows != nullptr ? kBesideShadows : 1.0f);
    glBindVertexArray(context.emptyArray);
    for (const DrawItem& item : frame.targets) {
        const Bounds bounds = worldBounds(item);
        if (bounds.empty()) {
            continue;
        }
        const glm::vec3 half = 0.5f * bounds.size();
        const float gap = std::max(bounds.centre().y - half.y - frame.floorHeight, 0.0f);
        const float nearness = 1.0f - gap / std::max(2.0f * half.y, 1.0e-6f);
        if (nearness <= 0.0f) {
            continue;
        }
        contact.set("u_centre", glm::vec3(bounds.centre().x, frame.floorHeight, bounds.centre().z));
        contact.set("u_reach", kShadeSpread * glm::vec2(half.x, half.z));
        contact.set("u_strength", strength * nearness);
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }
    return Done{};
}

}  // namespace hitscope::render
