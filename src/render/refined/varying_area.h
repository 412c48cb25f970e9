// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "pipeline/deformation_pipeline.h"
#include "render/frame_context.h"
#include "render/pixel_area.h"

namespace hitscope::render {

/// Radius of the directional light's disc, a metre away: 3 degrees.
inline constexpr float kLightSize = 0.055f;

/// Texels of a shadow map that the edge of a shadow is blurred by.
inline constexpr float kShadowTexels = 4.0f;

/// Pixels of a framebuffer.
struct DrawnPixels {
    PixelArea area;
    bool marked = false;   ///< only those whose stencil value is 1
    bool cleared = false;  ///< the caller has cleared them
};

/// What is drawn from now on is drawn within.
void limitDrawing(const PixelArea& area);
void limitDrawing(const DrawnPixels& pixels);

/// The box from the frame of a target in the world.
[[nodiscard]] Bounds inWorld(const Bounds& box, const DrawItem& item);
/// Metres that a texel of a software renderer's shadow map takes, or more.
[[nodiscard]] float shadowTexel(const Frame& frame, const DeformationPipeline& pipeline);
/// The box, larger on all sides; metres.
[[nodiscard]] Bounds grown(const Bounds& box, float by);
/// Where on the floor the shadow of what is in a box falls, world: between the two, all that it may shade.
/// Nothing: that is far away.
///
/// lightRadius: of the directional light, a metre away; texel: of the shadow map, metres.
[[nodiscard]] std::optional<Bounds> floorShadowOf(const Bounds& box, const Frame& frame, float lightRadius,
                                                  float texel);

/// Where samples of a refined picture can differ: at the targets, where these keep light away, and where
/// their shadows fall. Elsewhere there are only the background and the floor, which need no refining. The
/// whole picture, where that is not known or hardly smaller.
///
/// lightRadius: of the directional light, a metre away.
[[nodiscard]] PixelArea varyingArea(const FrameContext& context, const DeformationPipeline& pipeline,
                                    float lightRadius);

}  // namespace hitscope::render
