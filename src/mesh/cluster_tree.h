// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "core/bounds.h"
#include "core/page_vector.h"

namespace hitscope {

struct Cluster;

/// A tree of boxes around clusters: node i has children 2 i and 2 i + 1, the root is 1, and the leaves, one a
/// cluster, start in the middle. There are a power of two of them; those beyond the clusters are empty. It is
/// made once for a mesh: what follows its vertices as they move has copies that share what did not change.
using ClusterTree = PageVector<Bounds>;

[[nodiscard]] std::shared_ptr<const ClusterTree> clusterTreeOf(std::span<const Cluster> clusters);

}  // namespace hitscope
