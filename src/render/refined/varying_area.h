// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/deformation_pipeline.h"
#include "render/frame_context.h"
#include "render/pixel_area.h"

namespace hitscope::render {

/// Pixels of a framebuffer.
struct DrawnPixels {
    PixelArea area;
    bool marked = false;  ///< only those whose stencil value is 1
};

/// What is drawn from now on is drawn within.
void limitDrawing(const PixelArea& area);
void limitDrawing(const DrawnPixels& pixels);

/// Where samples of a refined picture can differ: at the targets, where these keep light away, and where
/// their shadows fall. Elsewhere there are only the background and the floor, which need no refining. The
/// whole picture, where that is not known or hardly smaller.
///
/// lightRadius: of the directional light, a metre away.
[[nodiscard]] PixelArea varyingArea(const FrameContext& context, const DeformationPipeline& pipeline,
                                    float lightRadius);

}  // namespace hitscope::render
