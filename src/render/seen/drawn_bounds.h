// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <optional>

#include "deform/cluster_reach.h"
#include "render/pixel_area.h"
#include "render/renderer.h"

namespace hitscope::render {

/// A part of a picture, in [-1, 1]^2, y up.
struct PictureWindow {
    glm::vec2 low{-1.0f};
    glm::vec2 high{1.0f};
};

/// A picture's area, of `picture` pixels.
[[nodiscard]] PictureWindow windowOf(const PixelArea& area, const glm::ivec2& picture);

/// The planes through the eye and a window's sides, and the near plane.
class WindowPlanes {
public:
    /// `toClip`: from the frame of the boxes to come.
    WindowPlanes(const glm::mat4& toClip, const PictureWindow& window);
    /// False: the box is wholly on the far side of one of them. One that is empty shows nothing.
    [[nodiscard]] bool mayShow(const Bounds& box) const;
    /// Whether all of the box is within.
    [[nodiscard]] bool holds(const Bounds& box) const;

private:
    std::array<glm::vec4, 5> m_planes;  ///< dot(plane, (point, 1)) >= 0 inside
};

/// Where a target's clusters are drawn, in its local frame. What they are read from outlives this.
class ClusterBoxes {
public:
    /// At the original.
    explicit ClusterBoxes(std::span<const Cluster> clusters) : m_clusters(clusters) {}
    explicit ClusterBoxes(const ClusterReach& reach) : m_reach(&reach) {}
    [[nodiscard]] Bounds of(std::size_t cluster) const {
        return m_reach != nullptr ? m_reach->bounds(cluster) : m_clusters[cluster].bounds;
    }
    /// Of groups of neighbouring clusters, `most` at most where vertices may have moved; they have all of
    /// them.
    [[nodiscard]] std::vector<Bounds> ofGroups(std::size_t most) const;
    /// Whether no vertex of it has moved.
    [[nodiscard]] bool isOriginal(std::size_t cluster) const {
        return m_reach == nullptr || m_reach->isOriginal(cluster);
    }

private:
    std::span<const Cluster> m_clusters;
    const ClusterReach* m_reach = nullptr;
};

/// Nothing: that is not known.
[[nodiscard]] std::optional<ClusterBoxes> clusterBoxesOf(const DrawItem& item, const Frame& frame,
                                                         const DeformationPipeline& pipeline);
/// Of all of them.
[[nodiscard]] std::optional<Bounds> drawnBounds(const DrawItem& item, const Frame& frame,
                                                const DeformationPipeline& pipeline);
/// As they are now, and about where exaggerated vertices are: after an undo as before.
[[nodiscard]] std::optional<Bounds> probableBounds(const DrawItem& item, const Frame& frame,
                                                   const DeformationPipeline& pipeline);

/// Whether some of the target may be drawn within the window; true where that is not known.
[[nodiscard]] bool mayShow(const DrawItem& item, const Frame& frame, const DeformationPipeline& pipeline,
                           const glm::mat4& viewProjection, const PictureWindow& window);

}  // namespace hitscope::render
