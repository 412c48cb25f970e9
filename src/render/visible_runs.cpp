// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/visible_runs.h"

#include <algorithm>

namespace hitscope::render {

namespace {

constexpr std::uint32_t kGap = 48;  // indices: so many cost less than another run

}  // namespace

std::optional<std::vector<IndexRun>> visibleRuns(const DrawItem& item, const Frame& frame,
                                                 const DeformationPipeline& pipeline,
                                                 const WindowPlanes& window, const ClusterRuns& runs,
                                                 const IndexRun& range) {
    const std::optional<Bounds> all = drawnBounds(item, frame, pipeline);
    const std::optional<ClusterBoxes> boxes = clusterBoxesOf(item, frame, pipeline);
    if (runs.runs().empty() || !all || !boxes || window.holds(*all)) {
        return std::nullopt;
    }
    const std::span<const ClusterRuns::Run> clusters = runs.runs();
    const auto first =
        std::partition_point(clusters.begin(), clusters.end(),
                             [&range](const ClusterRuns::Run& run) { return run.end <= range.first; });
    std::vector<IndexRun> visible;
    for (auto run = first; run != clusters.end() && run->first < range.end; ++run) {
        Bounds box = boxes->of(run->cluster);
        for (const std::uint32_t other : runs.others(static_cast<std::size_t>(run - clusters.begin()))) {
            box.add(boxes->of(other));
        }
        if (!window.mayShow(box)) {
            continue;
        }
        const IndexRun more{std::max(run->first, range.first), std::min(run->end, range.end)};
        if (visible.empty() || more.first > visible.back().end + kGap) {
            visible.push_back(more);
        }
        visible.back().end = more.end;
    }
    return visible;
}

std::optional<IndexRuns> visibleEdges(const DrawItem& item, const Frame& frame,
                                      const DeformationPipeline& pipeline, const glm::mat4& viewProjection,
                                      const PictureWindow& window) {
    const auto visible = visibleRuns(item, frame, pipeline, WindowPlanes(viewProjection * item.model, window),
                                     item.buffers->edgeRuns(), {0, item.buffers->edgeIndexCount()});
    if (!visible) {
        return std::nullopt;
    }
    IndexRuns runs;
    for (const IndexRun& run : *visible) {
        runs.add(run.first, run.end - run.first);
    }
    return runs;
}

}  // namespace hitscope::render
