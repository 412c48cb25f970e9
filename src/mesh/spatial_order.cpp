// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/spatial_order.h"

#include <algorithm>
#include <vector>

#include "core/give_up.h"
#include "core/parallel.h"

namespace hitscope {
namespace {

constexpr std::size_t kPointsAThread = 16384;  // fewer are done sooner than a thread is started

struct Point {
    glm::vec3 at;
    std::uint32_t index;
};

glm::length_t longestAxis(std::span<const Point> points) {
    Bounds box;
    for (const Point& point : points) {
        box.add(point.at);
    }
    const glm::vec3 size = box.size();
    if (size.x >= size.y && size.x >= size.z) {
        return 0;
    }
    return size.y >= size.z ? 1 : 2;
}

void split(std::span<Point> points, std::size_t threads) {
    if (points.size() <= kClusterVertices) {
        // Within a cluster the given order stays: it is the file's, and that serves the vertex cache.
        std::sort(points.begin(), points.end(),
                  [](const Point& a, const Point& b) { return a.index < b.index; });
        return;
    }
    if (points.size() > kStepsBetweenLooks) {
        mayGiveUp();
    }
    // The cut is at a multiple of the cluster size: each run of that size stays together.
    const std::size_t clusters = (points.size() + kClusterVertices - 1) / kClusterVertices;
    const std::size_t half = clusters / 2 * kClusterVertices;
    const glm::length_t axis = longestAxis(points);
    std::nth_element(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(half), points.end(),
                     [axis](const Point& a, const Point& b) {
                         return a.at[axis] != b.at[axis] ? a.at[axis] < b.at[axis] : a.index < b.index;
                     });
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
    std::vector<Point> sorted;
    sorted.reserve(points.size());
    for (const glm::vec3& point : points) {
        mayGiveUp(sorted.size());
        sorted.push_back({point, static_cast<std::uint32_t>(sorted.size())});
    }
    split(sorted, usefulThreads());
    std::vector<std::uint32_t> order;
    order.reserve(sorted.size());
    for (const Point& point : sorted) {
        order.push_back(point.index);
    }
    return order;
}

}  // namespace hitscope
