// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cluster_tree.h"

#include <algorithm>
#include <bit>

#include "mesh/render_mesh.h"

namespace hitscope {

std::shared_ptr<const ClusterTree> clusterTreeOf(std::span<const Cluster> clusters) {
    const std::size_t leaves = std::bit_ceil(std::max<std::size_t>(clusters.size(), 1));
    auto tree = std::make_shared<ClusterTree>(2 * leaves);
    for (std::size_t i = 0; i < clusters.size(); ++i) {
        (*tree)[leaves + i] = clusters[i].bounds;
    }
    for (std::size_t node = leaves - 1; node > 0; --node) {
        (*tree)[node] = (*tree)[2 * node];
        (*tree)[node].add((*tree)[2 * node + 1]);
    }
    return tree;
}

}  // namespace hitscope
