// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "render/drawn_bounds.h"
#include "render/index_runs.h"

namespace hitscope::render {

/// Of the triangles or edges in the range of the index buffer, those of clusters that may be drawn within the
/// window, in order; nothing: it may be all of them. Costs a look at each cluster of a target that is partly
/// outside.
///
/// runs: of the item's triangles or edges; none: they are not known.
[[nodiscard]] std::optional<std::vector<IndexRun>> visibleRuns(const DrawItem& item, const Frame& frame,
                                                               const DeformationPipeline& pipeline,
                                                               const WindowPlanes& window,
                                                               const ClusterRuns& runs,
                                                               const IndexRun& range);

/// The edges of a target likewise.
[[nodiscard]] std::optional<IndexRuns> visibleEdges(const DrawItem& item, const Frame& frame,
                                                    const DeformationPipeline& pipeline,
                                                    const glm::mat4& viewProjection,
                                                    const PictureWindow& window);

}  // namespace hitscope::render
