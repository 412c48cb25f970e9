// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <span>
#include <vector>

#include "render/frame_context.h"
#include "render/index_runs.h"

namespace hitscope::render {

/// What a program of surfaces has to have. What has least is drawn first.
struct SurfaceParts {
    bool translucent = false;
    bool textured = false;
    bool normalMapped = false;
    bool metalRough = false;
    bool metalRoughMapped = false;
    bool coloured = false;

    auto operator<=>(const SurfaceParts&) const = default;
};

/// A software renderer draws what is nearer first, in as many groups: the pixels of what lies behind are then
/// not shaded.
inline constexpr std::size_t kSurfaceGroups = 8;

/// Triangles of a target with one material.
struct SurfaceDraw {
    const DrawItem* item = nullptr;
    DrawRange range;                    ///< of all triangles or of the coarse ones
    const ClusterRuns* runs = nullptr;  ///< of these
    SurfaceParts parts;
    std::vector<std::vector<IndexRun>> groups;  ///< what is seen of the range, in the order of drawing
};

/// How many indices are in the groups from `first` on.
[[nodiscard]] std::size_t indicesFrom(std::span<const SurfaceDraw> draws, std::size_t first);

/// Those that the file or the look gives the target.
[[nodiscard]] const MaterialSet& materialsOf(const Frame& frame, const DrawItem& item);

/// The opaque surfaces of all targets, or of these the share of context.part; or the translucent ones. Those
/// for one program are neighbours.
[[nodiscard]] std::vector<SurfaceDraw> surfaceDraws(const FrameContext& context,
                                                    const DeformationPipeline& pipeline, bool translucent);

/// When the groups before `first` have been drawn into what is bound: leaves out of the others what is
/// hidden, where that may save a software renderer more than it costs. The picture is the same in every bit.
void leaveOutHidden(const FrameContext& context, const DeformationPipeline& pipeline,
                    std::span<SurfaceDraw> draws, std::size_t first);

}  // namespace hitscope::render
