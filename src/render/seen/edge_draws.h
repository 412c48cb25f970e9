// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "render/frame_context.h"
#include "render/index_runs.h"

namespace hitscope::render {

/// Where lines are drawn, from the edges that they stand for.
struct LineReach {
    int pixels = 0;           ///< around them, to all sides
    float depthShift = 0.0f;  ///< what is added to clip.z
};

/// Edges of a target.
struct EdgeDraw {
    const DrawItem* item = nullptr;
    std::vector<IndexRun> seen;  ///< what may be seen of the index buffer of edges, in order
};

/// What may be seen of the edges of a target in the picture; of a ghost, only what has changed. Costs a look
/// at each cluster of a target that is partly outside.
[[nodiscard]] EdgeDraw edgeDraw(const FrameContext& context, const DeformationPipeline& pipeline,
                                const DrawItem& item, const LineReach& reach, bool ghost);

/// When all surfaces have been drawn into what is bound: leaves out lines behind them, where that may save a
/// software renderer more than it costs. The picture is the same in every bit; with softpipe, which rounds
/// blended colours when depths are read, it may be off by a level.
void leaveOutHidden(const FrameContext& context, const DeformationPipeline& pipeline,
                    std::span<EdgeDraw> draws, const LineReach& reach);

}  // namespace hitscope::render
