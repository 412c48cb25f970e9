// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/spatial_order.h"

#include <algorithm>

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
    SpatialOrder& result;

    void split(std::size_t first, std::size_t count) {
        const auto members = std::span(result.order).subspan(first, count);
        if (count <= kClusterVertices) {
            // Within a cluster the given order stays: it is the file's, and that serves the vertex cache.
            std::sort(members.begin(), members.end());
            result.clusters.push_back({static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count),
                                       boxAround(points, members)});
            return;
        }
        // The cut is at a multiple of the cluster size, so that all clusters but the last are full.
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

SpatialOrder spatialOrder(std::span<const glm::vec3> points) {
    SpatialOrder result;
    if (points.empty()) {
        return result;
    }
    result.order.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        result.order[i] = static_cast<std::uint32_t>(i);
    }
    result.clusters.reserve(points.size() / kClusterVertices + 1);
    Splitter{points, result}.split(0, points.size());
    return result;
}

}  // namespace hitscope
