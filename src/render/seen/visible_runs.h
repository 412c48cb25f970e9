// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "render/index_runs.h"
#include "render/refined/marked_tiles.h"
#include "render/seen/drawn_bounds.h"
#include "render/seen/front_depths.h"

namespace hitscope::render {

/// Where something is drawn of a picture of that size, pixels; null: everywhere.
struct TilesOfPicture {
    const MarkedTiles* tiles = nullptr;
    glm::ivec2 picture{0};
};

/// What of a target can be seen in a picture.
class Sight {
public:
    /// toClip: from the frame of the boxes to come.
    Sight(const glm::mat4& toClip, const PictureWindow& window)
        : m_toClip(toClip), m_window(toClip, window) {}
    /// What is drawn reaches so many pixels beyond the boxes to all sides; none otherwise.
    void reachAround(int pixels) { m_around = pixels; }
    /// Nothing is drawn elsewhere. The tiles outlive this.
    void limitTo(const TilesOfPicture& tiles);
    /// Nothing is drawn behind what such a picture shows; null: nothing is hidden. Likewise.
    void hideBehind(const FrontDepths* front, const glm::ivec2& picture);
    [[nodiscard]] bool mayShow(const Bounds& box) const;
    /// Whether all of the box can be seen.
    [[nodiscard]] bool holds(const Bounds& box) const {
        return m_tiles == nullptr && m_front == nullptr && m_window.holds(box);
    }

private:
    glm::mat4 m_toClip;
    WindowPlanes m_window;
    glm::ivec2 m_picture{0};
    int m_around = 0;
    const MarkedTiles* m_tiles = nullptr;
    const FrontDepths* m_front = nullptr;
};

/// Around all elements of a run, wherever their vertices are and have been since the original.
[[nodiscard]] Bounds boxOf(const ClusterBoxes& boxes, const ClusterRuns& runs, std::size_t index);

/// Of the triangles or edges in the range of the index buffer, those of clusters that may be
/// seen, in order; nothing: it may be all of them. Costs a look at each cluster of a target that is partly
/// outside.
///
/// runs: of the item's triangles or edges; none: they are not known.
[[nodiscard]] std::optional<std::vector<IndexRun>> visibleRuns(const DrawItem& item, const Frame& frame,
                                                               const DeformationPipeline& pipeline,
                                                               const Sight& sight, const ClusterRuns& runs,
                                                               const IndexRun& range);

/// Calls use(cluster's run, what of it is in `seen`) for all of these, in order. seen: of the index buffer,
/// in order.
template <typename Use>
void forEachPart(std::span<const IndexRun> seen, const ClusterRuns& runs, const Use& use) {
    const std::span<const ClusterRuns::Run> clusters = runs.runs();
    if (seen.empty()) {
        return;
    }
    auto cluster = std::ranges::partition_point(
        clusters, [&seen](const ClusterRuns::Run& run) { return run.end <= seen.front().first; });
    for (const IndexRun& run : seen) {
        for (; cluster != clusters.end() && cluster->first < run.end; ++cluster) {
            const IndexRun part{std::max(cluster->first, run.first), std::min(cluster->end, run.end)};
            if (part.first < part.end) {
                use(*cluster, part);
            }
            if (cluster->end > run.end) {
                break;  // the next run has more of it
            }
        }
    }
}

/// The triangles of a target in groups by how far away the middles of their clusters' originals are, what is
/// nearer first; some groups may be empty. Which group a triangle is in depends on nothing but the view.
///
/// seen: what is drawn of the index buffer, in order; of `runs`, whose clusters have their originals within
/// `all`. forward: unit, along the view, in the target's local frame.
[[nodiscard]] std::vector<std::vector<IndexRun>> nearestFirst(std::span<const IndexRun> seen,
                                                              const ClusterRuns& runs, const Bounds& all,
                                                              const glm::vec3& forward, std::size_t groups);

}  // namespace hitscope::render
