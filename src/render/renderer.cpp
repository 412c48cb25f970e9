// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/renderer.h"

#include <array>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <utility>
#include <vector>

#include "render/ghost_pass.h"
#include "render/material_set.h"
#include "render/original_shape.h"
#include "render/renderer_private.h"
#include "render/target_pass.h"
#include "render/wire_pass.h"

namespace hitscope {

using namespace render;

namespace {

/// Programs that do not depend on a pipeline.
constexpr std::array<std::pair<const char*, const char*>, 8> kPrograms{
    {{"background.vert", "background.frag"},
     {"floor.vert", "floor.frag"},
     {"contact.vert", "contact.frag"},
     {"projectile.vert", "surface.frag"},
     {"trail.vert", "trail.frag"},
     {"dent_ghost.vert", "dent_ghost.frag"},
     {"ring.vert", "ring.frag"},
     {"crosshair.vert", "crosshair.frag"}}};

// glPolygonOffset's for the floor.
constexpr float kFloorSlopes = 1.0f;
constexpr float kFloorBehind = 2.0f;

void startBlending(const Frame& frame) {
    if (frame.options.transparent) {
        glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    } else {
        // The picture stays opaque whatever is drawn over it: the window is put together with others.
        glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    }
}

/// Pixels from the picture's left side.
int wipeLine(const Frame& frame) {
    return static_cast<int>(std::lround(frame.options.beforeAfter.wipeAt * static_cast<float>(frame.width)));
}

/// What was drawn so far says by its opacity how much of the background is to be seen.
Status drawBackgroundBehind(const FrameContext& context) {
    glDisable(GL_DEPTH_TEST);
    glBlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
    Status status = drawBackground(context);
    startBlending(context.frame);
    glEnable(GL_DEPTH_TEST);
    return status;
}

/// jitter: pixels that the picture is off to the right and up.
FrameContext makeContext(const Frame& frame, ProgramCache& programs, ColourTextures& colourTextures,
                         GLuint emptyArray, const glm::vec2& jitter) {
    const float aspect = static_cast<float>(frame.width) / static_cast<float>(frame.height);
    FrameContext context{.frame = frame,
                         .colours = themeColours(frame.options.theme),
                         .programs = programs,
                         .colourTextures = colourTextures,
                         .emptyArray = emptyArray};
    context.projection = frame.camera.projection(aspect);
    context.steadyViewProjection = context.projection * frame.camera.view();
    if (jitter != glm::vec2(0.0f)) {
        const glm::vec2 size(frame.width, frame.height);
        context.projection =
            glm::translate(glm::mat4(1.0f), glm::vec3(2.0f * jitter / size, 0.0f)) * context.projection;
    }
    context.viewProjection = context.projection * frame.camera.view();
    context.eye = frame.camera.eye();
    context.forward = frame.camera.forward();
    context.pixelsAtOneMetre = static_cast<float>(frame.height) / frame.camera.heightAt(1.0f);
    context.depthPerPixel =
        context.projection[frame.camera.isOrthographic() ? 2 : 3][2] / context.pixelsAtOneMetre;
    return context;
}

/// Targets that lie in its plane are in front of it, although the samples of a refined picture see them from
/// up to half a pixel beside where they see the floor.
Status drawFloorAndShades(const FrameContext& context) {
    if (!context.frame.options.floor) {
        return Done{};
    }
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(kFloorSlopes, kFloorBehind);
    Status status = drawFloor(context);
    if (status && context.frame.options.wireframe != WireframeMode::Only) {
        status = drawContactShades(context);
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
    return status;
}

Status drawShaded(const FrameContext& context, DeformationPipeline& pipeline) {
    if (Status status = drawSurfaces(context, pipeline); !status || !context.part.isLast()) {
        return status;
    }
    // Now, where it is not hidden.
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_LEQUAL);
    if (Status status = drawBackground(context); !status) {
        return status;
    }
    glDepthFunc(GL_LESS);
    startBlended();
    if (Status status = drawFloorAndShades(context); !status) {
        return status;
    }
    if (Status status = drawTranslucentSurfaces(context, pipeline); !status) {
        return status;
    }
    return context.frame.options.wireframe == WireframeMode::Over
               ? drawEdges(
                     context, pipeline,
                     {.colour = context.colours.wire, .leastPixels = kLeastEdge, .fade = kFadeOverSurface})
               : Status(Done{});
}

Status drawWires(const FrameContext& context, DeformationPipeline& pipeline) {
    if (Status status = drawWireSurfaces(context, pipeline); !status) {
        return status;
    }
    startBlended();
    if (Status status = drawBackgroundBehind(context); !status) {
        return status;
    }
    if (Status status = drawFloorAndShades(context); !status) {
        return status;
    }
    return drawWireLines(context, pipeline);
}

Status drawTargets(const FrameContext& context, DeformationPipeline& pipeline) {
    return context.frame.options.wireframe == WireframeMode::Only ? drawWires(context, pipeline)
                                                                  : drawShaded(context, pipeline);
}

}  // namespace

namespace render {

void prepareFramebuffer(const Frame& frame, GLuint framebuffer, const DrawnPixels* within, Before before) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(frame.left, 0, frame.width, frame.height);
    for (const GLenum capability : {GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_CULL_FACE, GL_FRAMEBUFFER_SRGB,
                                    GL_RASTERIZER_DISCARD, GL_COLOR_LOGIC_OP, GL_BLEND, GL_DEPTH_TEST}) {
        glDisable(capability);
    }
    if (within != nullptr) {
        limitDrawing(*within);
    }
    glEnable(GL_MULTISAMPLE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glLineWidth(1.0f);
    glBlendEquation(GL_FUNC_ADD);
    startBlending(frame);
    if (before == Before::Stays || (within != nullptr && within->cleared)) {
        return;
    }
    const bool isBeside = frame.left > 0 && within == nullptr;  // of another picture, which stays
    if (isBeside) {
        limitDrawing(PixelArea{frame.left, 0, frame.width, frame.height});
    }
    if (frame.options.transparent || frame.options.wireframe == WireframeMode::Only) {
        glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    glClearDepth(1.0);
    glClear(GL_DEPTH_BUFFER_BIT);
    if (isBeside) {
        glDisable(GL_SCISSOR_TEST);
    }
}

Status drawMarks(const FrameContext& context, DeformationPipeline& pipeline) {
    const Frame& frame = context.frame;
    if (!frame.options.beforeAfter.wipe) {
        return drawVertexMarks(context, pipeline);
    }
    const int line = wipeLine(frame);
    glEnable(GL_SCISSOR_TEST);
    glScissor(frame.left, 0, line, frame.height);
    Status status = drawVertexMarks(context, pipeline, MarkPlaces::Original);
    if (status) {
        glScissor(frame.left + line, 0, frame.width - line, frame.height);
        status = drawVertexMarks(context, pipeline);
    }
    glDisable(GL_SCISSOR_TEST);
    return status;
}

void startSolid() {
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

void startBlended() {
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
}

}  // namespace render

Status Renderer::Private::drawDotsAndNeedles(const FrameContext& context, DeformationPipeline& pipeline) {
    const DisplayOptions& options = context.frame.options;
    if (options.dots) {
        if (Status status = drawDots(context, pipeline); !status) {
            return status;
        }
    }
    return options.needles ? needles.draw(context, pipeline) : Status(Done{});
}

FrameContext Renderer::Private::contextOf(const Frame& frame) {
    FrameContext context = makeContext(frame, programs, colourTextures, emptyArray.id(), jitter);
    context.software = software;
    context.drewCoarse = &wasCoarse;
    context.occlusion = occlusion;
    if (isStudioWanted(frame)) {
        studio.prepare(frame);
        context.studio = &studio;
    }
    return context;
}

Status Renderer::Private::drawGhosts(const Frame& frame, DeformationPipeline& pipeline) {
    const GhostMode mode = frame.options.beforeAfter.ghost;
    if (mode == GhostMode::Off) {
        return Done{};
    }
    OriginalFrame originals(frame);
    return render::drawGhosts(contextOf(originals.frame), pipeline, mode);
}

Status Renderer::Private::drawScene(const FrameContext& context, DeformationPipeline& pipeline) {
    if (Status status = drawTargets(context, pipeline); !status || !context.part.isLast()) {
        return status;
    }
    if (Status status = drawGhosts(context.frame, pipeline); !status) {
        return status;
    }
    return drawDotsAndNeedles(context, pipeline);
}

/// The originals left of the line, what has become of them right of it.
Status Renderer::Private::drawWiped(const FrameContext& context, DeformationPipeline& pipeline) {
    const Frame& frame = context.frame;
    const int line = wipeLine(frame);
    const OriginalFrame originals(frame);
    const float split = 2.0f * static_cast<float>(line) / static_cast<float>(frame.width) - 1.0f;
    FrameContext before = contextOf(originals.frame);
    before.shadows = context.shadows != nullptr ? &originalShadowsFor(*context.shadows) : nullptr;
    before.floorLayers = context.floorLayers;
    before.textureSampler = context.textureSampler;
    before.window = PictureWindow{.high = glm::vec2(split, 1.0f)};
    FrameContext after = context;
    after.window = PictureWindow{.low = glm::vec2(split, -1.0f)};
    glEnable(GL_SCISSOR_TEST);
    glScissor(frame.left, 0, line, frame.height);
    Status status = drawTargets(before, originalShape);
    if (status) {
        glScissor(frame.left + line, 0, frame.width - line, frame.height);
        startSolid();
        status = drawScene(after, pipeline);
    }
    glDisable(GL_SCISSOR_TEST);
    return status;
}

Renderer::Renderer() : d(std::make_unique<Private>()) {}
Renderer::~Renderer() = default;

Result<std::unique_ptr<Renderer>> Renderer::create() {
    const KeepState keep;
    std::unique_ptr<Renderer> renderer(new Renderer());
    for (const auto& [vertex, fragment] : kPrograms) {
        if (auto program = renderer->d->programs.get(vertex, fragment); !program) {
            return program.error();
        }
    }
    return renderer;
}

std::shared_ptr<const MaterialSet> Renderer::makeMaterials(const MeshData& mesh) {
    return std::make_shared<const MaterialSet>(mesh);
}

std::shared_ptr<const MaterialSet> Renderer::makeCover(const Image& texture) {
    return std::make_shared<const MaterialSet>(texture);
}

Status Renderer::Private::drawPicture(const FrameContext& context, DeformationPipeline& pipeline,
                                      GLuint framebuffer, const DrawnPixels* within) {
    const bool isFirst = context.part.isFirst();
    const bool isWiped = context.frame.options.beforeAfter.wipe;
    // A map that was never drawn is warmed up with.
    if (isWiped && context.shadows != nullptr && context.shadows->direction() != glm::vec3(0.0f)) {
        if (Status status = updateOriginalShadows(context); !status) {
            return status;
        }
    }
    prepareFramebuffer(context.frame, framebuffer, within, isFirst ? Before::Goes : Before::Stays);
    startSolid();
    if (Status status = isFirst ? projectiles.draw(context) : Status(Done{}); !status) {
        return status;
    }
    Status status = isWiped ? drawWiped(context, pipeline) : drawScene(context, pipeline);
    if (!status || !context.part.isLast()) {
        return status;
    }
    startBlended();
    return sections.draw(context);
}

Status Renderer::Private::drawOver(const FrameContext& context) {
    if (Status status = drawHighlightedHit(context); !status) {
        return status;
    }
    if (Status status = drawCutPane(context); !status) {
        return status;
    }
    if (Status status = dentGhost.draw(context); !status) {
        return status;
    }
    return drawCrosshair(context);
}

bool Renderer::wasCoarse() const {
    return d->wasCoarse;
}

Status Renderer::draw(const Frame& given, DeformationPipeline& pipeline, GLuint framebuffer) {
    d->wasCoarse = false;
    if (given.width <= 0 || given.height <= 0) {
        return Done{};
    }
    const KeepState keep;
    const LitFrame lit(given);
    FrameContext context = d->contextOf(lit.frame());
    if (Status status = d->updateShadows(context, pipeline); !status) {
        return status;
    }
    if (Status status = d->drawPicture(context, pipeline, framebuffer); !status) {
        return status;
    }
    if (Status status = drawMarks(context, pipeline); !status) {
        return status;
    }
    if (Status status = d->trails.draw(context); !status) {
        return status;
    }
    return d->drawOver(context);
}

}  // namespace hitscope
