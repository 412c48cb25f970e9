// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/seen/edge_draws.h"

#include <algorithm>
#include <cstddef>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>

#include "render/changed_parts.h"
#include "render/seen/covered_squares.h"
#include "render/seen/front_depths.h"
#include "render/seen/visible_runs.h"

namespace hitscope::render {
namespace {

/// A picture's depths are read in about the time in which a software renderer draws an edge for each 64 of
/// its pixels. Before that it has to finish what was drawn, and events wait for that.
constexpr std::size_t kPixelsAnEdge = 32;
constexpr std::size_t kFewestEdges = 1024;

/// A little beyond the picture's edges for the lines' width.
PictureWindow linesWindow(const FrameContext& context) {
    constexpr glm::vec2 kReach(1.05f);
    return context.window.value_or(PictureWindow{-kReach, kReach});
}

glm::ivec2 pictureOf(const FrameContext& context) {
    return {context.frame.width, context.frame.height};
}

Sight sightOf(const FrameContext& context, const DrawItem& item, const LineReach& reach) {
    glm::mat4 toClip = context.viewProjection * item.model;
    toClip[3].z += reach.depthShift;
    Sight sight(toClip, linesWindow(context));
    sight.reachAround(reach.pixels);
    return sight;
}

IndexRun everyEdge(const DrawItem& item) {
    return {0, item.buffers->edgeIndexCount()};
}

/// About how many edges lie behind nearer halves of targets.
std::size_t probablyHidden(const FrameContext& context, std::span<const EdgeDraw> draws) {
    std::vector<std::pair<float, const EdgeDraw*>> nearer;
    for (const EdgeDraw& draw : draws) {
        nearer.emplace_back(glm::dot(worldBounds(*draw.item).centre(), context.forward), &draw);
    }
    std::ranges::sort(nearer);
    CoveredSquares squares;
    std::size_t hidden = 0;
    for (const auto& [depth, draw] : nearer) {
        const DrawItem& item = *draw->item;
        const ClusterRuns& runs = item.buffers->edgeRuns();
        const glm::mat4 toClip = context.viewProjection * item.model;
        const auto halves =
            nearestFirst(draw->seen, runs, item.buffers->originalBounds(), alongView(context, item), 2);
        for (const std::vector<IndexRun>& half : halves) {
            hidden += squares.covered(toClip, runs, half) / 2;
            if (&half == &halves.front()) {
                squares.cover(toClip, runs, half);
            }
        }
    }
    return hidden;
}

/// Whether about so many edges are hidden that it is worth a look.
bool mayHideMany(const FrameContext& context, std::span<const EdgeDraw> draws, const PixelArea& area) {
    std::size_t all = 0;
    for (const EdgeDraw& draw : draws) {
        all += countOf(draw.seen) / 2;
    }
    const std::size_t pixels = static_cast<std::size_t>(area.width) * static_cast<std::size_t>(area.height);
    const std::size_t many = std::max({kFewestEdges, pixels / kPixelsAnEdge, all / 8});
    if (all < many) {
        return false;
    }
    return probablyHidden(context, draws) >= many;
}

std::optional<FrontDepths> readDepths(const FrameContext& context, std::span<const EdgeDraw> draws) {
    const glm::ivec2 picture = pictureOf(context);
    const PixelArea whole{0, 0, picture.x, picture.y};
    const PixelArea area = context.tiles != nullptr ? intersected(context.tiles->area(), whole) : whole;
    if (area.empty() || !mayHideMany(context, draws, area) || !FrontDepths::areReadable()) {
        return std::nullopt;
    }
    return FrontDepths::ofBound(context.frame.left, area);
}

}  // namespace

EdgeDraw edgeDraw(const FrameContext& context, const DeformationPipeline& pipeline, const DrawItem& item,
                  const LineReach& reach, bool ghost) {
    const IndexRun all = everyEdge(item);
    Sight sight = sightOf(context, item, reach);
    sight.limitTo({context.tiles, pictureOf(context)});
    if (!mayShow(item, context.frame, pipeline, context.viewProjection, linesWindow(context))) {
        return {&item, {}};
    }
    EdgeDraw draw{&item, visibleRuns(item, context.frame, pipeline, sight, item.buffers->edgeRuns(), all)
                             .value_or(std::vector{all})};
    if (ghost && item.changedParts != nullptr) {
        draw.seen = within(draw.seen, item.changedParts->edges());
    }
    return draw;
}

void leaveOutHidden(const FrameContext& context, const DeformationPipeline& pipeline,
                    std::span<EdgeDraw> draws, const LineReach& reach) {
    if (!context.software) {
        return;
    }
    std::optional<FrontDepths> read;
    const FrontDepths* front = context.front;
    if (front == nullptr && (read = readDepths(context, draws))) {
        front = &*read;
    }
    if (front == nullptr) {
        return;
    }
    for (EdgeDraw& draw : draws) {
        Sight sight = sightOf(context, *draw.item, reach);
        sight.hideBehind(front, pictureOf(context));
        if (const auto seen = visibleRuns(*draw.item, context.frame, pipeline, sight,
                                          draw.item->buffers->edgeRuns(), everyEdge(*draw.item))) {
            draw.seen = within(*seen, draw.seen);
        }
    }
}

}  // namespace hitscope::render
