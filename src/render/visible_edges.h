// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/drawn_bounds.h"
#include "render/index_runs.h"

namespace hitscope::render {

/// The edges of a target, of its clusters that may be drawn within the window; nothing: it may be all of
/// them. Costs a look at each cluster of a target that is partly outside.
[[nodiscard]] std::optional<IndexRuns> visibleEdges(const DrawItem& item, const Frame& frame,
                                                    const DeformationPipeline& pipeline,
                                                    const glm::mat4& viewProjection,
                                                    const PictureWindow& window);

}  // namespace hitscope::render
