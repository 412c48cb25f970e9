// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/visible_edges.h"

namespace hitscope::render {

namespace {

constexpr std::uint32_t kGap = 16;  // edges: so many cost less than another run

}  // namespace

std::optional<IndexRuns> visibleEdges(const DrawItem& item, const Frame& frame,
                                      const DeformationPipeline& pipeline, const glm::mat4& viewProjection,
                                      const PictureWindow& window) {
    const WindowPlanes planes(viewProjection * item.model, window);
    const std::optional<Bounds> all = drawnBounds(item, frame, pipeline);
    const std::optional<ClusterBoxes> boxes = clusterBoxesOf(item, frame, pipeline);
    if (!all || !boxes || planes.holds(*all)) {
        return std::nullopt;
    }
    const ClusterEdges& edges = item.buffers->clusterEdges();
    IndexRuns runs;
    ClusterEdges::Run run;
    const auto finishRun = [&runs, &run] {
        if (run.end > run.first) {
            runs.add(2 * std::size_t{run.first}, 2 * std::size_t{run.end - run.first});
        }
    };
    for (std::size_t cluster = 0; cluster < item.buffers->clusters().size(); ++cluster) {
        Bounds box = boxes->of(cluster);
        for (const std::uint32_t other : edges.endsOf(cluster)) {
            box.add(boxes->of(other));
        }
        if (!planes.mayShow(box)) {
            continue;
        }
        const ClusterEdges::Run more = edges.of(cluster);
        if (more.first > run.end + kGap) {
            finishRun();
            run = more;
        }
        run.end = more.end;
    }
    finishRun();
    return runs;
}

}  // namespace hitscope::render
