// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/median_split.h"

namespace hitscope {

/// Puts points in an order in which neighbours in space are neighbours, above all those of each run of
/// kClusterVertices; within a run they come by index. Halves the points on their longest axis again and
/// again: O(n log n) for n points.
void orderBySpace(std::span<PlacedItem> points);

}  // namespace hitscope
