// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/spatial_order.h"

#include <algorithm>
#include <vector>

#include "core/give_up.h"
#include "core/median_split.h"
#include "core/parallel.h"

namespace hitscope {
namespace {

constexpr std::size_t kPointsAThread = 16384;  // fewer are done sooner than a thread is started

void split(std::span<PlacedItem> points, std::size_t threads) {
    if (points.size() <= kClusterVertices) {
        // Within a cluster the given order stays: it is the file's, and that serves the vertex cache.
        std::sort(points.begin(), points.end(),
                  [](const PlacedItem& a, const PlacedItem& b) { return a.index < b.index; });
        return;
    }
    if (points.size() > kStepsBetweenLooks) {
        mayGiveUp();
    }
    // The cut is at a multiple of the cluster size: each run of that size stays together.
    const std::size_t clusters = (points.size() + kClusterVertices - 1) / kClusterVertices;
    const std::size_t half = clusters / 2 * kClusterVertices;
    splitOnLongestAxis(points, half);
    const auto first = [&] { split(points.first(half), threads / 2); };
    const auto second = [&] { split(points.subspan(half), threads - threads / 2); };
    if (threads > 1 && points.size() >= kPointsAThread) {
        bothAtOnce(first, second);
    } else {
        first();
        second();
    }
}

}  // namespace

std::vector<std::uint32_t> spatialOrder(std::span<const glm::vec3> points) {
    std::vector<PlacedItem> sorted;
    sorted.reserve(points.size());
    for (const glm::vec3& point : points) {
        mayGiveUp(sorted.size());
        sorted.push_back({point, static_cast<std::uint32_t>(sorted.size())});
    }
    split(sorted, usefulThreads());
    std::vector<std::uint32_t> order;
    order.reserve(sorted.size());
    for (const PlacedItem& point : sorted) {
        order.push_back(point.index);
    }
    return order;
}

}  // namespace hitscope
