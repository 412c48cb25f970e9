// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <glm/matrix.hpp>

#include "render/frame_context.h"

namespace hitscope::render {
namespace {

constexpr int kDepthsUnit = 4;
constexpr float kOfTarget = 0.08f;  // of the largest target's diagonal: about as wide as a dent
constexpr float kOfPicture =
    0.12f;  // of the picture's height, where the camera looks: what is seen from close by

}  // namespace

float occlusionReach(const Frame& frame) {
    float largest = 0.0f;
    for (const DrawItem& item : frame.targets) {
        largest = std::max(largest, item.buffers->originalBounds().diagonal());
    }
    const float seen = kOfPicture * frame.camera.heightAt(frame.camera.distance());
    return std::max(std::min(kOfTarget * largest, seen), 1.0e-9f);
}

gl::Defines occlusionDefines(const FrameContext& context) {
    if (context.occlusion == nullptr) {
        return {};
    }
    return {{"HITSCOPE_OCCLUSION", "1"}};
}

void setOcclusion(const gl::Program& program, const FrameContext& context, const glm::vec2& offset) {
    if (context.occlusion == nullptr) {
        return;
    }
    const Frame& frame = context.frame;
    const Occlusion& occlusion = *context.occlusion;
    const glm::vec2 half(0.5f * static_cast<float>(frame.width), 0.5f * static_cast<float>(frame.height));
    program.set("u_nearDepths", kDepthsUnit);
    program.set("u_toView", glm::mat3(frame.camera.view()));
    program.set("u_nearPlace", glm::vec4(half, offset));
    program.set("u_nearScale", glm::vec4(1.0f / context.pixelsAtOneMetre, context.projection[2][2],
                                         context.projection[3][2], occlusionReach(frame)));
    program.set("u_nearTurn", occlusion.turn);
    glActiveTexture(GL_TEXTURE0 + kDepthsUnit);
    glBindSampler(kDepthsUnit, 0);
    glBindTexture(GL_TEXTURE_2D, occlusion.depths);
    glActiveTexture(GL_TEXTURE0);
}

}  // namespace hitscope::render
