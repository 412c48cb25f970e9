// SPDX-License-Identifier: GPL-3.0-or-later
// Samples of refined pictures.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

#include "render/refined/moved_area.h"
#include "render/renderer_private.h"

namespace hitscope {

using namespace render;

namespace {

/// A software renderer transforms vertices as far ahead of its pixels as it gets, and whoever shows the
/// picture would wait for all of these at once. So many samples, or parts of them, are ahead at most: its
/// pixels are shaded while the next one's vertices are transformed.
constexpr std::size_t kMostAhead = 1;

/// Of fewer, the last ones are drawn sooner than what hides them is known.
constexpr std::uint32_t kFewestParts = 4;

/// The way that the light travels from a place (unit disc) on it.
glm::vec3 placeOnLight(const glm::vec3& given, const glm::vec2& place) {
    const float length = glm::length(given);
    const glm::vec3 way = length > 1.0e-6f ? given / length : glm::vec3(0.0f, -1.0f, 0.0f);
    const glm::vec3 aside =
        glm::normalize(glm::cross(way, std::abs(way.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0)));
    return glm::normalize(way + kLightSize * (place.x * aside + place.y * glm::cross(way, aside)));
}

/// Colours that stand for a quantity stay as they are, and lines alone have no surface.
bool hasOcclusion(const Frame& frame) {
    return !frame.change && frame.options.wireframe != WireframeMode::Only;
}

/// Samples lie a part of a pixel apart: together they need no anisotropic filter, which takes a software
/// renderer as long as everything else, and each may be sharper than a picture of its own would be.
gl::Sampler makeSampleTextures() {
    gl::Sampler sampler = gl::Sampler::make();
    glSamplerParameteri(sampler.id(), GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glSamplerParameteri(sampler.id(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glSamplerParameterf(sampler.id(), GL_TEXTURE_LOD_BIAS, -1.0f);
    return sampler;
}

/// Whether something is drawn over the scene that the scene may hide.
bool hasOverlays(const Frame& frame) {
    return !frame.marks.empty() || frame.highlightedHit || frame.showsCutPlane || frame.ghost ||
           frame.projectilesFly;
}

Status drawFloorOpen(const FrameContext& given, const RefinedPicture& picture) {
    const Occlusion near{picture.depths(), glm::vec2(0.0f), glm::vec2(0.0f)};
    FrameContext context = given;
    context.occlusion = &near;
    const glm::ivec2 size = picture.floorOpenSize();
    // And one pixel around it, as those between are a mean of four.
    constexpr int kStep = RefinedPicture::kFloorOpenStep;
    const PixelArea& area = picture.area();
    const PixelArea around{area.x / kStep - 1, area.y / kStep - 1, area.width / kStep + 4,
                           area.height / kStep + 4};
    glBindFramebuffer(GL_FRAMEBUFFER, picture.floorOpenFramebuffer());
    glViewport(0, 0, size.x, size.y);
    limitDrawing(around);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    return render::drawFloorOpen(context, size);
}

/// The floor differs from sample to sample only in how much of the directional light arrives.
Status drawFloorLayers(const FrameContext& context, const RefinedPicture& picture) {
    if (!context.frame.options.floor) {
        return Done{};
    }
    const bool isOccluded = hasOcclusion(context.frame);
    if (isOccluded) {
        if (Status drawn = drawFloorOpen(context, picture); !drawn) {
            return drawn;
        }
    }
    glViewport(context.frame.left, 0, context.frame.width, context.frame.height);
    for (const bool isShaded : {false, true}) {
        glBindFramebuffer(GL_FRAMEBUFFER, picture.floorFramebuffer(isShaded));
        limitDrawing(picture.area());
        glDisable(GL_BLEND);
        glDisable(GL_DEPTH_TEST);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        if (Status status = drawFloorLayer(context, isShaded, isOccluded ? picture.floorOpen() : 0);
            !status) {
            return status;
        }
    }
    return Done{};
}

/// Other than software renderers do not keep anybody waiting.
std::uint32_t partsOf(const FrameContext& context, const DeformationPipeline& pipeline,
                      const RefinedPicture& picture) {
    const Frame& frame = context.frame;
    if (!context.software || frame.options.wireframe == WireframeMode::Only ||
        frame.options.beforeAfter.wipe) {
        return 1;
    }
    const std::size_t triangles =
        context.window ? trianglesWithin(context, pipeline, context.viewProjection, *context.window,
                                         {context.tiles, {frame.width, frame.height}})
                       : trianglesOf(frame);
    return static_cast<std::uint32_t>(1 + triangles / picture.trianglesAPart());
}

}  // namespace

Status Renderer::Private::drawPart(FrameContext& context, DeformationPipeline& pipeline,
                                   RefinedPicture& picture, GLuint framebuffer, const DrawnPixels* within) {
    context.part.index = picture.nextPart();
    if (software && context.front == nullptr && context.part.count >= kFewestParts) {
        context.front = picture.frontOfParts(context, framebuffer, within);
    }
    if (Status status = drawPicture(context, pipeline, framebuffer, within); !status) {
        return status;
    }
    picture.setNextPart(context.part.isLast() ? 0 : context.part.index + 1, context.part.count);
    return Done{};
}

ShadowMap& Renderer::Private::sampleShadowsAt(int place) {
    constexpr int kKept = RefinedPicture::LightPlace::kKept;
    while (sampleShadows.size() <= kKept) {
        sampleShadows.emplace_back(software, ShadowMap::Edges::Sampled);
    }
    return sampleShadows[static_cast<std::size_t>(std::min(place, kKept))];
}

Status Renderer::Private::addSample(const Frame& frame, DeformationPipeline& pipeline,
                                    RefinedPicture& picture) {
    const RefinedPicture::Sample sample = RefinedPicture::sampleAt(picture.samples());
    const Occlusion near{picture.depths(), sample.jitter, sample.turn};
    const bool isPlain = !picture.isBegun();
    if (!isPlain) {
        jitter = sample.jitter;
        occlusion = hasOcclusion(frame) ? &near : nullptr;
    }
    FrameContext context = contextOf(frame);
    if (const std::optional<PixelArea> part = picture.partToDraw()) {
        context.window = windowAround(*part, frame);
    }
    std::optional<MarkedTiles> rough;
    if (!picture.rough().empty()) {
        rough = MarkedTiles::around(picture.roughParts());
        context.tiles = &*rough;
    }
    context.part.count = picture.nextPart() > 0 ? picture.parts() : partsOf(context, pipeline, picture);
    if (ShadowMap::isWanted(frame)) {
        Frame lit = frame;
        const RefinedPicture::LightPlace place = picture.nextLight(software);
        if (!isPlain) {
            lit.lights.directional.direction = placeOnLight(frame.lights.directional.direction, place.at);
        }
        ShadowMap& map = isPlain ? shadows : sampleShadowsAt(place.index);
        const FrameContext cast = contextOf(lit);
        const bool isInTurn = context.part.count > 1 && !map.isUpToDate(cast, pipeline);
        Status updated = map.update(cast, pipeline, context.part.count);
        if (!updated || !map.isWhole() || isInTurn) {
            return updated;
        }
        context.shadows = &map;
    }
    return isPlain ? begin(context, pipeline, picture) : drawSample(context, pipeline, picture);
}

Status Renderer::Private::drawPlain(FrameContext& context, DeformationPipeline& pipeline,
                                    RefinedPicture& picture) {
    // Beside the picture, which is shown as it is meanwhile.
    const DrawnPixels rough{picture.rough()};
    const bool isRough = !rough.area.empty();
    if (Status drawn = drawPart(context, pipeline, picture,
                                isRough ? picture.sampleFramebuffer() : picture.plainFramebuffer(),
                                isRough ? &rough : nullptr);
        !drawn || !context.part.isLast()) {
        return drawn;
    }
    if (Status drawn = trails.draw(context); !drawn) {
        return drawn;
    }
    if (isRough) {
        if (Status taken = picture.takeFromSample(programs, emptyArray.id(), picture.roughParts()); !taken) {
            return taken;
        }
    }
    picture.plainDrawn(momentsOf(context.frame),
                       context.shadows != nullptr ? context.shadows->margin() : 0.0f);
    return Done{};
}

Status Renderer::Private::begin(FrameContext& context, DeformationPipeline& pipeline,
                                RefinedPicture& picture) {
    if (!picture.hasPicture() || !picture.rough().empty()) {
        return drawPlain(context, pipeline, picture);
    }
    picture.begin(varyingArea(context, pipeline, kLightSize), software && !context.frame.options.transparent);
    return drawFloorLayers(context, picture);
}

Status Renderer::Private::drawSample(FrameContext& context, DeformationPipeline& pipeline,
                                     RefinedPicture& picture) {
    if (software) {
        if (!sampleTextures) {
            sampleTextures = makeSampleTextures();
        }
        context.textureSampler = sampleTextures.id();
    }
    const FloorLayers floor = picture.floorLayers();
    context.floorLayers = &floor;
    const DrawnPixels within = picture.drawnPixels();
    context.tiles = picture.unsettled();
    context.front = picture.front();
    if (Status drawn = drawPart(context, pipeline, picture, picture.sampleFramebuffer(), &within);
        !drawn || !context.part.isLast()) {
        return drawn;
    }
    if (Status status = trails.draw(context); !status) {
        return status;
    }
    return picture.add(programs, emptyArray.id());
}

Status Renderer::drawPlain(const Frame& given, DeformationPipeline& pipeline, RefinedPicture& picture) {
    d->wasCoarse = false;
    if (given.width <= 0 || given.height <= 0) {
        return Done{};
    }
    const KeepState keep;
    if (picture.prepare(given.width, given.height, d->software) != RefinedPicture::Made::All) {
        return Done{};
    }
    picture.clear();
    const LitFrame lit(given);
    FrameContext context = d->contextOf(lit.frame());
    if (Status updated = d->updateShadows(context, pipeline); !updated) {
        return updated;
    }
    return d->drawPlain(context, pipeline, picture);
}

Status Renderer::refine(const Frame& given, DeformationPipeline& pipeline, RefinedPicture& picture) {
    if (given.width <= 0 || given.height <= 0) {
        return Done{};
    }
    const KeepState keep;
    if (d->refining.size() > kMostAhead) {
        d->refining.front().wait();
    }
    const RefinedPicture::Made made = picture.prepare(given.width, given.height, d->software);
    if (made == RefinedPicture::Made::Part) {
        return Done{};
    }
    if (made == RefinedPicture::Made::None) {
        return Error{"This graphics driver cannot sum up pictures of " + std::to_string(given.width) + " x " +
                         std::to_string(given.height) + " pixels.",
                     "", "Choose a smaller size, or a single sample."};
    }
    picture.readWhatIsDue();
    const LitFrame lit(given);
    Status status = d->addSample(lit.frame(), pipeline, picture);
    d->jitter = glm::vec2(0.0f);
    d->occlusion = nullptr;
    if (d->software) {
        d->refining.emplace_back();
        if (d->refining.size() > kMostAhead + 1) {
            d->refining.pop_front();
        }
    }
    return status;
}

bool Renderer::isBehindRefining(const RefinedPicture& picture) const {
    if (d->refining.empty()) {
        return false;
    }
    const bool waitsForAll = picture.isReadingDue();
    return (waitsForAll || d->refining.size() > kMostAhead) &&
           !(waitsForAll ? d->refining.back() : d->refining.front()).isPassed();
}

Result<bool> Renderer::isPlainShown(const Frame& frame, RefinedPicture& picture, int fewest) {
    if (!picture.hasPicture() || hasOverlays(frame) || frame.options.crosshair) {
        return false;
    }
    const KeepState keep;
    if (const Status kept = picture.keepMean(d->programs, d->emptyArray.id()); !kept) {
        return kept.error();
    }
    return picture.isPlainShown(fewest);
}

Status Renderer::drawRefined(const Frame& given, DeformationPipeline& pipeline, RefinedPicture& picture,
                             GLuint framebuffer, int fewest) {
    if (given.width <= 0 || given.height <= 0 || !picture.hasPicture()) {
        return Done{};
    }
    const KeepState keep;
    const LitFrame lit(given);
    const Frame& frame = lit.frame();
    const FrameContext context = d->contextOf(frame);
    if (Status kept = picture.keepMean(d->programs, d->emptyArray.id()); !kept) {
        return kept;
    }
    prepareFramebuffer(frame, framebuffer);
    if (Status status = picture.draw(d->programs, d->emptyArray.id(), hasOverlays(frame), fewest); !status) {
        return status;
    }
    if (frame.projectilesFly) {
        startSolid();
        if (Status status = d->projectiles.draw(context); !status) {
            return status;
        }
    }
    startBlended();
    if (Status status = drawMarks(context, pipeline); !status) {
        return status;
    }
    if (Status status = frame.projectilesFly ? d->trails.draw(context) : Status(Done{}); !status) {
        return status;
    }
    return d->drawOver(context);
}

}  // namespace hitscope
