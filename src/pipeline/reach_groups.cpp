// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/reach_groups.h"

#include <algorithm>
#include <map>
#include <utility>

namespace hitscope {
namespace {

using ClusterHit = std::pair<std::uint32_t, std::uint32_t>;  // index of the cluster, index of the hit

/// Every (cluster, hit) of the batch, sorted.
std::vector<ClusterHit> clusterHits(TargetReach& reach, std::span<const Hit* const> hits) {
    const std::span<const Cluster> clusters = reach.clusters();
    std::vector<ClusterHit> found;
    for (std::uint32_t hit = 0; hit < hits.size(); ++hit) {
        for (const VertexRange& range : reach.advance(*hits[hit])) {
            auto cluster =
                std::lower_bound(clusters.begin(), clusters.end(), range.first,
                                 [](const Cluster& c, std::uint32_t first) { return c.first < first; });
            for (; cluster != clusters.end() && cluster->first < range.first + range.count; ++cluster) {
                found.emplace_back(static_cast<std::uint32_t>(cluster - clusters.begin()), hit);
            }
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace

std::vector<ReachGroup> groupByReach(TargetReach& reach, std::span<const Hit* const> hits) {
    const std::vector<ClusterHit> found = clusterHits(reach, hits);
    std::map<std::vector<std::uint32_t>, std::vector<VertexRange>> byHits;
    for (auto begin = found.begin(); begin != found.end();) {
        std::vector<std::uint32_t> reaching;
        auto end = begin;
        for (; end != found.end() && end->first == begin->first; ++end) {
            reaching.push_back(end->second);
        }
        const Cluster& cluster = reach.clusters()[begin->first];
        byHits[std::move(reaching)].push_back({cluster.first, cluster.count});
        begin = end;
    }
    std::vector<ReachGroup> groups;
    groups.reserve(byHits.size());
    for (auto& [reaching, ranges] : byHits) {
        groups.push_back({reaching, merged(std::move(ranges))});
    }
    return groups;
}

}  // namespace hitscope
