// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "render/frame_context.h"

namespace hitscope::render {

/// A frame of the same targets as they were: shaded, where they were.
struct OriginalFrame {
    explicit OriginalFrame(const Frame& frame);
    OriginalFrame(const OriginalFrame&) = delete;
    OriginalFrame& operator=(const OriginalFrame&) = delete;

    std::vector<DrawItem> items;
    Frame frame;
};

/// The changed targets as they were over what has become of them, in an OriginalFrame; `pipeline` has what
/// has become of them. Blending is on, depth test GL_LESS, depth writes off. Where nothing moved nothing is
/// seen: a surface has the very depths of what is there, edges are left out.
[[nodiscard]] Status drawGhosts(const FrameContext& originals, DeformationPipeline& pipeline, GhostMode mode);

}  // namespace hitscope::render
