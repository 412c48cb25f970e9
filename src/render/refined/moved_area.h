// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "pipeline/deformation_pipeline.h"
#include "render/frame_context.h"
#include "render/pixel_area.h"
#include "render/seen/visible_runs.h"

namespace hitscope::render {

/// Of its targets, the moments at which a picture of the frame shows them (DrawItem::settled).
[[nodiscard]] std::vector<std::uint64_t> momentsOf(const Frame& frame);

/// Boxes that hold all triangles of a target with a corner that may have moved since a moment of its own
/// (ClusterReach::moment()), as they were and as they are. Its frame. Nothing: that is not known.
[[nodiscard]] std::optional<std::vector<Bounds>> movedTriangles(const DrawItem& item, const Frame& frame,
                                                                const DeformationPipeline& pipeline,
                                                                std::uint64_t moment);

/// Where a picture of the frame differs from one that shows the targets at these moments of theirs: where
/// moved surfaces were and are, what is around them, whose normals follow, and all that their shadows may
/// fall on. Nothing: it is not known, or anything differs.
struct MovedArea {
    std::vector<PixelArea> plain;      ///< they may overlap
    std::optional<PixelArea> refined;  ///< see PicturePatch
};
[[nodiscard]] std::optional<MovedArea> movedArea(const FrameContext& context,
                                                 const DeformationPipeline& pipeline,
                                                 std::span<const std::uint64_t> moments);

/// Triangles that drawing within a window, and tiles of it, takes.
[[nodiscard]] std::size_t trianglesWithin(const FrameContext& context, const DeformationPipeline& pipeline,
                                          const glm::mat4& viewProjection, const PictureWindow& window,
                                          const TilesOfPicture& tiles = {});

/// Of all targets.
[[nodiscard]] std::size_t trianglesOf(const Frame& frame);

/// The window to draw an area with: what is as wide as a line may reach into it from outside.
[[nodiscard]] PictureWindow windowAround(const PixelArea& area, const Frame& frame);

}  // namespace hitscope::render
