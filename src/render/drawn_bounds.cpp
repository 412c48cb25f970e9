// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/drawn_bounds.h"

#include <array>

namespace hitscope::render {

namespace {

/// Local frame; empty: not known.
Bounds boundsOf(const DrawItem& item, const Frame& frame, const DeformationPipeline& pipeline) {
    if (item.original) {
        return item.buffers->originalBounds();
    }
    return frame.options.beforeAfter.exaggeration == 1.0f ? pipeline.bounds(item.target) : Bounds();
}

}  // namespace

bool mayShow(const DrawItem& item, const Frame& frame, const DeformationPipeline& pipeline,
             const glm::mat4& viewProjection, const PictureWindow& window) {
    const Bounds bounds = boundsOf(item, frame, pipeline);
    if (bounds.empty()) {
        return true;
    }
    // Outside of one of the window's sides with all eight corners: then with all in between.
    const glm::mat4 toClip = viewProjection * item.model;
    std::array<bool, 4> outside{true, true, true, true};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec4 at = toClip * glm::vec4((corner & 1) != 0 ? bounds.max.x : bounds.min.x,
                                                (corner & 2) != 0 ? bounds.max.y : bounds.min.y,
                                                (corner & 4) != 0 ? bounds.max.z : bounds.min.z, 1.0f);
        outside[0] = outside[0] && at.x < window.low.x * at.w;
        outside[1] = outside[1] && at.x > window.high.x * at.w;
        outside[2] = outside[2] && at.y < window.low.y * at.w;
        outside[3] = outside[3] && at.y > window.high.y * at.w;
    }
    return !outside[0] && !outside[1] && !outside[2] && !outside[3];
}

}  // namespace hitscope::render
