// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/spatial_order.h"

#include <algorithm>
#include <numeric>

namespace hitscope {
namespace {

Bounds boxAround(std::span<const glm::vec3> points, std::span<const std::uint32_t> members) {
    Bounds box;
    for (const std::uint32_t member : members) {
        box.add(points[member]);
    }
    return box;
}

struct Splitter {
    std::span<const glm::vec3> points;
    std::span<std::uint32_t> order;

    void split(std::size_t first, std::size_t count) {
        const auto members = order.subspan(first, count);
        if (count <= kClusterVertices) {
            // Within a cluster the given order stays: it is the file's, and that serves the vertex cache.
            std::sort(members.begin(), members.end());
            return;
        }
        // The cut is at a multiple of the cluster size: each run of that size stays together.
        const std::size_t clusters = (count + kClusterVertices - 1) / kClusterVertices;
        const std::size_t half = clusters / 2 * kClusterVertices;
        const glm::length_t axis = longestAxis(members);
        std::nth_element(members.begin(), members.begin() + static_cast<std::ptrdiff_t>(half), members.end(),
                         [this, axis](std::uint32_t a, std::uint32_t b) {
                             return points[a][axis] != points[b][axis] ? points[a][axis] < points[b][axis]
                                                                       : a < b;
                         });
        split(first, half);
        split(first + half, count - half);
    }

    [[nodiscard]] glm::length_t longestAxis(std::span<const std::uint32_t> members) const {
        const glm::vec3 size = boxAround(points, members).size();
        if (size.x >= size.y && size.x >= size.z) {
            return 0;
        }
        return size.y >= size.z ? 1 : 2;
    }
};

}  // namespace

std::vector<std::uint32_t> spatialOrder(std::span<const glm::vec3> points) {
    std::vector<std::uint32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0u);
    if (!points.empty()) {
        Splitter{points, order}.split(0, points.size());
    }
    return order;
}

}  // namespace hitscope
