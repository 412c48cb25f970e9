// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/seen/drawn_bounds.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace hitscope::render {

namespace {

/// Null: where the pipeline draws it is not known.
const ClusterReach* reachOf(const DrawItem& item, const Frame& frame, const DeformationPipeline& pipeline) {
    return frame.options.beforeAfter.exaggeration == 1.0f ? pipeline.reach(item.target) : nullptr;
}

/// How far the corner of the box that has its highest x, y and z where `high` says so lies over the plane, in
/// the plane's own measure.
float heightOver(const glm::vec4& plane, const Bounds& box, const glm::bvec3& high) {
    return glm::dot(glm::vec3(plane), glm::mix(box.min, box.max, high)) + plane.w;
}

}  // namespace

PictureWindow windowOf(const PixelArea& area, const glm::ivec2& picture) {
    const glm::vec2 step = 2.0f / glm::vec2(picture);
    const glm::vec2 low(area.x, area.y);
    return {step * low - 1.0f, step * (low + glm::vec2(area.width, area.height)) - 1.0f};
}

WindowPlanes::WindowPlanes(const glm::mat4& toClip, const PictureWindow& window) {
    const glm::mat4 rows = glm::transpose(toClip);
    m_planes = {rows[0] - window.low.x * rows[3], window.high.x * rows[3] - rows[0],
                rows[1] - window.low.y * rows[3], window.high.y * rows[3] - rows[1], rows[2] + rows[3]};
}

bool WindowPlanes::mayShow(const Bounds& box) const {
    return !box.empty() && std::all_of(m_planes.begin(), m_planes.end(), [&box](const glm::vec4& plane) {
        return heightOver(plane, box, glm::greaterThan(glm::vec3(plane), glm::vec3(0.0f))) >= 0.0f;
    });
}

bool WindowPlanes::holds(const Bounds& box) const {
    return !box.empty() && std::all_of(m_planes.begin(), m_planes.end(), [&box](const glm::vec4& plane) {
        return heightOver(plane, box, glm::lessThan(glm::vec3(plane), glm::vec3(0.0f))) >= 0.0f;
    });
}

std::vector<Bounds> ClusterBoxes::ofGroups(std::size_t most) const {
    if (m_reach != nullptr) {
        return m_reach->boundsOfGroups(most);
    }
    std::vector<Bounds> all(m_clusters.size());
    std::transform(m_clusters.begin(), m_clusters.end(), all.begin(),
                   [](const Cluster& cluster) { return cluster.bounds; });
    return all;
}

std::optional<ClusterBoxes> clusterBoxesOf(const DrawItem& item, const Frame& frame,
                                           const DeformationPipeline& pipeline) {
    if (item.original) {
        return ClusterBoxes(item.buffers->clusters());
    }
    const ClusterReach* reach = reachOf(item, frame, pipeline);
    return reach != nullptr ? std::optional(ClusterBoxes(*reach)) : std::nullopt;
}

std::optional<Bounds> drawnBounds(const DrawItem& item, const Frame& frame,
                                  const DeformationPipeline& pipeline) {
    if (item.original) {
        return item.buffers->originalBounds();
    }
    const ClusterReach* reach = reachOf(item, frame, pipeline);
    return reach != nullptr ? std::optional(reach->bounds()) : std::nullopt;
}

std::optional<Bounds> probableBounds(const DrawItem& item, const Frame& frame,
                                     const DeformationPipeline& pipeline) {
    const float exaggeration = frame.options.beforeAfter.exaggeration;
    const ClusterReach* reach = pipeline.reach(item.target);
    if (item.original || reach == nullptr) {
        return drawnBounds(item, frame, pipeline);
    }
    if (exaggeration == 1.0f) {
        return reach->boundsNow();
    }
    // Clusters are flat: where they bulge, their boxes have moved as far as their vertices.
    Bounds all = item.buffers->originalBounds();
    for (std::size_t i = 0; i < reach->clusters().size(); ++i) {
        if (!reach->isOriginal(i)) {
            const Bounds& before = reach->clusters()[i].bounds;
            const Bounds now = reach->boundsNow(i);
            all.add(before.min + exaggeration * (now.min - before.min));
            all.add(before.max + exaggeration * (now.max - before.max));
        }
    }
    return all;
}

bool mayShow(const DrawItem& item, const Frame& frame, const DeformationPipeline& pipeline,
             const glm::mat4& viewProjection, const PictureWindow& window) {
    const std::optional<Bounds> bounds = drawnBounds(item, frame, pipeline);
    return !bounds || WindowPlanes(viewProjection * item.model, window).mayShow(*bounds);
}

}  // namespace hitscope::render
