// SPDX-License-Identifier: GPL-3.0-or-later
// A kept picture, drawn again where vertices have moved.
#include <algorithm>

#include "render/refined/moved_area.h"
#include "render/renderer_private.h"

namespace hitscope {

using namespace render;

namespace {

/// Of hurried patches with all triangles, and their shadows: events wait until a software renderer has
/// transformed them, which takes it 160 ns each.
constexpr std::size_t kMostTriangles = 100'000;

bool isMost(const MarkedTiles& tiles, const Frame& frame) {
    constexpr double kNearlyWhole = 0.85;
    return static_cast<double>(tiles.pixels()) > kNearlyWhole * frame.width * frame.height;
}

bool hasCoarse(const Frame& frame) {
    return std::any_of(frame.targets.begin(), frame.targets.end(),
                       [](const DrawItem& item) { return !item.buffers->coarseDraws().empty(); });
}

}  // namespace

std::optional<PicturePatch> Renderer::patchFor(const Frame& given, const DeformationPipeline& pipeline,
                                               const RefinedPicture& picture, bool isHurried) {
    if (!d->software || !picture.hasPicture()) {
        return std::nullopt;
    }
    const LitFrame lit(given);
    const FrameContext context = d->contextOf(lit.frame());
    const std::optional<MovedArea> moved = movedArea(context, pipeline, picture.moments());
    if (!moved) {
        return std::nullopt;
    }
    if (ShadowMap::isWanted(lit.frame()) &&
        ShadowMap::marginOf(lit.frame(), pipeline) != picture.shadowMargin()) {
        return std::nullopt;  // texels of shadows lie elsewhere now, all over the picture
    }
    std::vector<PixelArea> parts = moved->plain;
    parts.insert(parts.end(), picture.roughParts().begin(), picture.roughParts().end());
    const MarkedTiles tiles = MarkedTiles::around(parts);
    if (isMost(tiles, given)) {
        return std::nullopt;
    }
    const glm::ivec2 size(given.width, given.height);
    PicturePatch patch{.area = intersected(tiles.area(), {0, 0, size.x, size.y}),
                       .parts = tiles.rectangles(),
                       .refined = moved->refined};
    if (isHurried && hasCoarse(given)) {
        const std::size_t cast =
            ShadowMap::isWanted(lit.frame()) ? d->shadows.trianglesToDraw(context, pipeline) : 0;
        patch.isCoarse = cast + trianglesWithin(context, pipeline, context.viewProjection,
                                                windowAround(patch.area, given), {&tiles, size}) >
                         kMostTriangles;
    }
    return patch;
}

Status Renderer::patch(const Frame& given, DeformationPipeline& pipeline, RefinedPicture& picture,
                       const PicturePatch& patch) {
    d->wasCoarse = false;
    const KeepState keep;
    Frame still = given;
    if (given.projectilesFly) {
        still.projectiles = {};
    }
    const LitFrame lit(still);
    FrameContext context = d->contextOf(lit.frame());
    if (!patch.area.empty()) {
        if (Status updated = d->updateShadows(context, pipeline); !updated) {
            return updated;
        }
    }
    if (Status kept = picture.keepMean(d->programs, d->emptyArray.id()); !kept) {
        return kept;
    }
    if (!patch.area.empty()) {
        context.window = windowAround(patch.area, context.frame);
        const MarkedTiles tiles = MarkedTiles::around(patch.parts);
        context.tiles = &tiles;
        picture.clearForPatch(patch);
        const DrawnPixels within{.area = patch.area, .marked = true, .cleared = true};
        if (Status drawn = d->drawPicture(context, pipeline, picture.plainFramebuffer(), &within); !drawn) {
            return drawn;
        }
        if (Status drawn = d->trails.draw(context); !drawn) {
            return drawn;
        }
    }
    picture.patched(patch, momentsOf(given));
    return Done{};
}

}  // namespace hitscope
