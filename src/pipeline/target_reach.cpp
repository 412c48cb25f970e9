// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/target_reach.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace hitscope {
namespace {

/// Distance of the vertex farthest from `centre`, rounded up.
float reach(const glm::vec3& centre, std::span<const DynamicVertex> vertices) {
    double radius = 0.0;
    for (const DynamicVertex& vertex : vertices) {
        radius = std::max(radius, glm::distance(glm::dvec3(vertex.position), glm::dvec3(centre)));
    }
    return std::nextafter(static_cast<float>(radius), std::numeric_limits<float>::infinity());
}

Sphere enclosing(std::span<const DynamicVertex> vertices) {
    Bounds box;
    for (const DynamicVertex& vertex : vertices) {
        box.add(vertex.position);
    }
    return {box.centre(), reach(box.centre(), vertices)};
}

}  // namespace

TargetReach::TargetReach(std::span<const Cluster> clusters)
    : m_original(clusters), m_clusters(clusters.begin(), clusters.end()), m_reach(clusters) {}

void TargetReach::place(std::uint32_t first, std::span<const DynamicVertex> vertices) {
    const auto end = first + static_cast<std::uint32_t>(vertices.size());
    auto cluster = std::partition_point(m_clusters.begin(), m_clusters.end(),
                                        [first](const Cluster& c) { return c.first + c.count <= first; });
    for (; cluster != m_clusters.end() && cluster->first < end; ++cluster) {
        const std::uint32_t begin = std::max(cluster->first, first);
        const std::uint32_t count = std::min(cluster->first + cluster->count, end) - begin;
        const std::span<const DynamicVertex> placed = vertices.subspan(begin - first, count);
        if (count == cluster->count) {
            cluster->bounds = enclosing(placed);
        } else {
            cluster->bounds.radius = std::max(cluster->bounds.radius, reach(cluster->bounds.centre, placed));
        }
    }
}

void TargetReach::reset() {
    m_clusters.assign(m_original.begin(), m_original.end());
    update();
}

}  // namespace hitscope
