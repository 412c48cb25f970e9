// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/spatial_order.h"

#include <algorithm>

#include "core/give_up.h"
#include "core/parallel.h"
#include "mesh/render_mesh.h"

namespace hitscope {
namespace {

constexpr std::size_t kPointsAThread = 16384;  // fewer are done sooner than a thread is started

void order(std::span<PlacedItem> points, std::size_t threads) {
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
    const auto first = [&] { order(points.first(half), threads / 2); };
    const auto second = [&] { order(points.subspan(half), threads - threads / 2); };
    if (threads > 1 && points.size() >= kPointsAThread) {
        bothAtOnce(first, second);
    } else {
        first();
        second();
    }
}

}  // namespace

void orderBySpace(std::span<PlacedItem> points) {
    order(points, usefulThreads());
}

}  // namespace hitscope
