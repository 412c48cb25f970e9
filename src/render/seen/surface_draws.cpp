// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/seen/surface_draws.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstddef>
#include <optional>

#include "render/material_set.h"
#include "render/seen/covered_squares.h"
#include "render/seen/front_depths.h"
#include "render/seen/visible_runs.h"
#include "render/surface_looks.h"

namespace hitscope::render {
namespace {

SurfaceParts partsOf(const Frame& frame, const DrawItem& item, std::uint32_t material) {
    const MaterialSet& materials = materialsOf(frame, item);
    const bool shaded = !frame.change;
    const bool pictures = shaded && frame.options.textures;
    return {.translucent = materials.isTranslucent(material),
            .textured = pictures && materials.isTextured(material),
            .normalMapped = pictures && !frame.options.flat && materials.hasNormalMap(material),
            .metalRough = shaded && materials.hasMetalRoughness(material),
            .metalRoughMapped = pictures && materials.hasMetalRoughnessMap(material),
            .coloured = shaded && frame.options.vertexColours && item.buffers->hasColours() &&
                        frame.options.look == SurfaceLook::File && !(pictures && materials.isCover())};
}

/// Whether any of its surfaces is translucent, or any is not.
bool hasAny(const Frame& frame, const DrawItem& item, bool translucent) {
    return std::ranges::any_of(item.buffers->draws(), [&](const DrawRange& range) {
        return partsOf(frame, item, range.material).translucent == translucent;
    });
}

/// From close by, much of a target lies beside the picture. A GPU draws it sooner than the CPU has found it.
/// runs: the item's, of all triangles or of the coarse ones.
std::optional<std::vector<IndexRun>> seenOf(const FrameContext& context, const DeformationPipeline& pipeline,
                                            const DrawItem& item, const ClusterRuns& runs,
                                            const DrawRange& range) {
    if (!context.software) {
        return std::nullopt;
    }
    Sight sight(context.viewProjection * item.model, context.window.value_or(PictureWindow{}));
    const glm::ivec2 picture(context.frame.width, context.frame.height);
    sight.limitTo({context.tiles, picture});
    sight.hideBehind(context.front, picture);
    return visibleRuns(item, context.frame, pipeline, sight, runs, {range.first, range.first + range.count});
}

struct ItemDraws {
    std::span<const DrawRange> draws;
    std::optional<std::vector<IndexRun>> seen;  ///< nothing: all of them, or each finds its own
};

/// Where a coarse picture shows little of a target, all of that has no more triangles than the coarse shape.
ItemDraws drawsOf(const FrameContext& context, const DeformationPipeline& pipeline, const DrawItem& item) {
    const std::span<const DrawRange> coarse = hitscope::drawsOf(item, context.frame.coarse);
    const std::span<const DrawRange> all = item.buffers->draws();
    if (coarse.data() == all.data()) {
        return {all, std::nullopt};
    }
    auto seen = seenOf(context, pipeline, item, item.buffers->triangleRuns(),
                       {0, item.buffers->triangleIndexCount()});
    const std::size_t few = item.buffers->coarseIndexCount();
    return seen && countOf(*seen) <= few ? ItemDraws{all, std::move(seen)} : ItemDraws{coarse, std::nullopt};
}

/// Of a range. seen: what can be seen of the item; nothing: that is not known yet.
std::vector<std::vector<IndexRun>> groupsOf(const FrameContext& context, const DeformationPipeline& pipeline,
                                            const DrawItem& item, const ClusterRuns& runs,
                                            const DrawRange& range, bool translucent,
                                            const std::optional<std::vector<IndexRun>>& seen) {
    std::vector<IndexRun> drawn{{range.first, range.first + range.count}};
    if (auto found = seen ? std::optional(within(*seen, drawn.front()))
                          : seenOf(context, pipeline, item, runs, range)) {
        drawn = std::move(*found);
    }
    if (!context.software || translucent) {
        return {std::move(drawn)};
    }
    return nearestFirst(drawn, runs, item.buffers->originalBounds(), alongView(context, item),
                        kSurfaceGroups);
}

/// The part of a range that is drawn now: parts whose middles are nearer come first.
DrawRange partOf(const FrameContext& context, const DrawItem& item, const ClusterRuns& runs,
                 const DrawRange& range) {
    const std::span<const ClusterRuns::Run> clusters = runs.runs();
    if (context.part.count == 1 || clusters.empty()) {
        return context.part.of(range);
    }
    const glm::vec3 forward = alongView(context, item);
    std::vector<std::pair<float, std::uint32_t>> order;
    for (std::uint32_t index = 0; index < context.part.count; ++index) {
        const DrawRange part = SurfacePart{index, context.part.count}.of(range);
        const std::uint32_t middle = part.first + part.count / 2;
        const auto run =
            std::partition_point(clusters.begin(), clusters.end(),
                                 [middle](const ClusterRuns::Run& before) { return before.end <= middle; });
        const Bounds& bounds = (run == clusters.end() ? clusters.back() : *run).bounds;
        order.emplace_back(glm::dot(bounds.centre(), forward), index);
    }
    std::ranges::sort(order);
    return SurfacePart{order[context.part.index].second, context.part.count}.of(range);
}

/// A picture's depths are read in about the time in which a software renderer transforms a triangle for each
/// sixteen of its pixels. Before that it has to finish what was drawn, and events wait for that.
constexpr std::size_t kPixelsATriangle = 16;
constexpr std::size_t kFewestTriangles = 32768;

/// Whether about so many triangles of the groups from `first` on are hidden that it is worth a look.
bool mayHideMany(const FrameContext& context, std::span<const SurfaceDraw> draws, std::size_t first,
                 const PixelArea& area) {
    const std::size_t left = indicesFrom(draws, first) / 3;
    const std::size_t pixels = static_cast<std::size_t>(area.width) * static_cast<std::size_t>(area.height);
    const std::size_t many = std::max({kFewestTriangles, pixels / kPixelsATriangle, left / 4});
    if (left < many) {
        return false;
    }
    CoveredSquares squares;
    for (const SurfaceDraw& draw : draws) {
        for (std::size_t group = 0; group < std::min(first, draw.groups.size()); ++group) {
            squares.cover(context.viewProjection * draw.item->model, *draw.runs, draw.groups[group]);
        }
    }
    std::size_t hidden = 0;
    for (const SurfaceDraw& draw : draws) {
        for (std::size_t group = first; group < draw.groups.size(); ++group) {
            hidden +=
                squares.covered(context.viewProjection * draw.item->model, *draw.runs, draw.groups[group]) /
                3;
        }
    }
    return hidden >= many;
}

}  // namespace

std::size_t indicesFrom(std::span<const SurfaceDraw> draws, std::size_t first) {
    std::size_t indices = 0;
    for (const SurfaceDraw& draw : draws) {
        for (std::size_t group = first; group < draw.groups.size(); ++group) {
            indices += countOf(draw.groups[group]);
        }
    }
    return indices;
}

const MaterialSet& materialsOf(const Frame& frame, const DrawItem& item) {
    static const MaterialSet defaults;
    if (const MaterialSet* look = materialOfLook(frame.options.look)) {
        return *look;
    }
    return item.materials != nullptr ? *item.materials : defaults;
}

std::vector<SurfaceDraw> surfaceDraws(const FrameContext& context, const DeformationPipeline& pipeline,
                                      bool translucent) {
    std::vector<SurfaceDraw> draws;
    for (const DrawItem& item : context.frame.targets) {
        if (!hasAny(context.frame, item, translucent) || !context.mayShow(item, pipeline)) {
            continue;
        }
        const auto [ranges, seen] = drawsOf(context, pipeline, item);
        const bool isCoarse = ranges.data() != item.buffers->draws().data();
        const ClusterRuns& runs = isCoarse ? item.buffers->coarseRuns() : item.buffers->triangleRuns();
        if (isCoarse && context.drewCoarse != nullptr) {
            *context.drewCoarse = true;
        }
        for (const DrawRange& range : ranges) {
            const SurfaceParts parts = partsOf(context.frame, item, range.material);
            // Translucent ones come when all others are there.
            const DrawRange drawn = translucent ? range : partOf(context, item, runs, range);
            if (drawn.count > 0 && parts.translucent == translucent) {
                draws.push_back({&item, drawn, &runs, parts,
                                 groupsOf(context, pipeline, item, runs, drawn, translucent, seen)});
            }
        }
    }
    std::stable_sort(draws.begin(), draws.end(),
                     [](const SurfaceDraw& a, const SurfaceDraw& b) { return a.parts < b.parts; });
    return draws;
}

void leaveOutHidden(const FrameContext& context, const DeformationPipeline& pipeline,
                    std::span<SurfaceDraw> draws, std::size_t first) {
    const glm::ivec2 picture(context.frame.width, context.frame.height);
    const PixelArea whole{0, 0, picture.x, picture.y};
    const PixelArea area = context.tiles != nullptr ? intersected(context.tiles->area(), whole) : whole;
    if (!context.software || context.front != nullptr || context.part.count > 1 || area.empty()) {
        return;
    }
    if (!mayHideMany(context, draws, first, area) || !FrontDepths::areReadable()) {
        return;
    }
    const FrontDepths front = FrontDepths::ofBound(context.frame.left, area);
    for (SurfaceDraw& draw : draws) {
        Sight sight(context.viewProjection * draw.item->model, context.window.value_or(PictureWindow{}));
        sight.hideBehind(&front, picture);
        const IndexRun range{draw.range.first, draw.range.first + draw.range.count};
        const auto seen = visibleRuns(*draw.item, context.frame, pipeline, sight, *draw.runs, range);
        if (!seen) {
            continue;
        }
        for (std::size_t group = first; group < draw.groups.size(); ++group) {
            draw.groups[group] = within(*seen, draw.groups[group]);
        }
    }
}

}  // namespace hitscope::render
