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

/// The originals of changed targets over what has become of them, as options.beforeAfter.ghost of the frame
/// that `originals` was made from says. Blending is on, depth test GL_LESS, depth writes off: where nothing
/// moved the ghost has the surface's very depths and is not seen.
[[nodiscard]] Status drawGhosts(const FrameContext& originals, GhostMode mode);

}  // namespace hitscope::render
