// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/target_reach.h"

namespace hitscope {

/// Vertices of one target that may be reached by the same hits of a batch.
struct ReachGroup {
    std::vector<std::uint32_t> hits;  ///< indices into the batch, in order
    std::vector<VertexRange> ranges;  ///< sorted, merged; no vertex is in two groups
};

/// Sorts a batch of hits by the clusters they reach, so that a vertex meets only hits that may reach it.
/// Order matters only within a vertex, so groups may be done in any order. Advances `reach` over all hits
/// (all on its target).
[[nodiscard]] std::vector<ReachGroup> groupByReach(TargetReach& reach, std::span<const Hit* const> hits);

}  // namespace hitscope
