// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "render/frame_context.h"
#include "render/seen/visible_runs.h"

namespace hitscope::render {

/// The opaque parts of the targets' surfaces, or of these the share of context.part. Depth test and writes
/// are on.
[[nodiscard]] Status drawSurfaces(const FrameContext& context, DeformationPipeline& pipeline);
/// The translucent parts. Blending is on, depth writes are off.
[[nodiscard]] Status drawTranslucentSurfaces(const FrameContext& context, DeformationPipeline& pipeline);
/// Whether a cutting plane counts.
enum class DepthOf : std::uint8_t { Seen, Whole };
/// Only the depth of the surfaces, or of the share of context.part: hides what a wireframe without surfaces
/// would show through them. Targets whose edges are shorter than `leastEdge` (logical pixels) are left out.
/// within: nothing else can be drawn to; tiles: of that, nothing else is wanted.
[[nodiscard]] Status drawSurfaceDepth(const FrameContext& context, DeformationPipeline& pipeline,
                                      const glm::mat4& viewProjection, DepthOf what, float leastEdge = 0.0f,
                                      const std::optional<PictureWindow>& within = {},
                                      const TilesOfPicture& tiles = {});

}  // namespace hitscope::render
