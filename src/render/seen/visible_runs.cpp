// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/seen/visible_runs.h"

#include <algorithm>

#include "render/seen/seen_area.h"

namespace hitscope::render {

namespace {

/// What is worked out here and by the renderer may differ by so much.
constexpr float kDepthStep = 4.0f / (1 << 24);

constexpr std::uint32_t kGap = 48;  // indices: so many cost less than another run

void add(std::vector<IndexRun>& runs, const IndexRun& more) {
    if (runs.empty() || runs.back().end != more.first) {
        runs.push_back(more);
    }
    runs.back().end = more.end;
}

}  // namespace

Bounds boxOf(const ClusterBoxes& boxes, const ClusterRuns& runs, std::size_t index) {
    const ClusterRuns::Run& run = runs.runs()[index];
    const std::span<const std::uint32_t> others = runs.others(index);
    const auto isOriginal = [&boxes](std::uint32_t cluster) { return boxes.isOriginal(cluster); };
    if (isOriginal(run.cluster) && std::all_of(others.begin(), others.end(), isOriginal)) {
        return run.bounds;
    }
    Bounds box = boxes.of(run.cluster);
    for (const std::uint32_t other : others) {
        box.add(boxes.of(other));
    }
    return box;
}

void Sight::limitTo(const TilesOfPicture& tiles) {
    m_tiles = tiles.tiles;
    m_picture = tiles.picture;
}

void Sight::hideBehind(const FrontDepths* front, const glm::ivec2& picture) {
    m_front = front;
    m_picture = picture;
}

bool Sight::mayShow(const Bounds& box) const {
    if (!m_window.mayShow(box)) {
        return false;
    }
    if (m_tiles == nullptr && m_front == nullptr) {
        return true;
    }
    SeenArea seen(m_toClip);
    if (!seen.add(box)) {
        return true;
    }
    return (m_tiles == nullptr || m_tiles->any(seen.in(m_picture, kSampleReach + m_around))) &&
           (m_front == nullptr ||
            !m_front->hide(seen.in(m_picture, m_front->off() + m_around), seen.nearest() - kDepthStep));
}

std::optional<std::vector<IndexRun>> visibleRuns(const DrawItem& item, const Frame& frame,
                                                 const DeformationPipeline& pipeline, const Sight& sight,
                                                 const ClusterRuns& runs, const IndexRun& range) {
    const std::optional<Bounds> all = drawnBounds(item, frame, pipeline);
    const std::optional<ClusterBoxes> boxes = clusterBoxesOf(item, frame, pipeline);
    if (runs.runs().empty() || !all || !boxes || sight.holds(*all)) {
        return std::nullopt;
    }
    const std::span<const ClusterRuns::Run> clusters = runs.runs();
    const auto first =
        std::partition_point(clusters.begin(), clusters.end(),
                             [&range](const ClusterRuns::Run& run) { return run.end <= range.first; });
    std::vector<IndexRun> visible;
    for (auto run = first; run != clusters.end() && run->first < range.end; ++run) {
        if (!sight.mayShow(boxOf(*boxes, runs, static_cast<std::size_t>(run - clusters.begin())))) {
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

std::vector<std::vector<IndexRun>> nearestFirst(std::span<const IndexRun> seen, const ClusterRuns& runs,
                                                const Bounds& all, const glm::vec3& forward,
                                                std::size_t groups) {
    if (runs.runs().empty() || seen.empty()) {
        return {{seen.begin(), seen.end()}};
    }
    std::vector<std::vector<IndexRun>> sorted(groups);
    const float reach = 0.5f * glm::dot(all.size(), glm::abs(forward));
    const float nearest = glm::dot(all.centre(), forward) - reach;
    const float perMetre = reach > 0.0f ? static_cast<float>(groups) / (2.0f * reach) : 0.0f;
    const float last = static_cast<float>(groups) - 1.0f;
    forEachPart(seen, runs, [&](const ClusterRuns::Run& run, const IndexRun& part) {
        const float depth = (glm::dot(run.bounds.centre(), forward) - nearest) * perMetre;
        add(sorted[depth > 0.0f ? static_cast<std::size_t>(std::min(depth, last)) : 0], part);
    });
    return sorted;
}

}  // namespace hitscope::render
