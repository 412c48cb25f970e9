// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/renderer.h"

#include <array>
#include <cmath>
#include <utility>

#include "gl/context.h"
#include "render/frame_context.h"
#include "render/ghost_pass.h"
#include "render/gl_state.h"
#include "render/material_set.h"
#include "render/projectile_pass.h"
#include "render/target_pass.h"
#include "render/trail_pass.h"

namespace hitscope {

using namespace render;

namespace {

constexpr float kSelectedLines = 0.7f;  // of the accent colour, where lines are all there is to a target
constexpr float kHiddenLines = 0.16f;   // opacity of lines behind a surface, of that of the others

/// Programs that do not depend on a pipeline.
constexpr std::array<std::pair<const char*, const char*>, 8> kPrograms{
    {{"background.vert", "background.frag"},
     {"floor.vert", "floor.frag"},
     {"contact.vert", "contact.frag"},
     {"projectile.vert", "surface.frag"},
     {"trail.vert", "trail.frag"},
     {"ghost.vert", "ghost.frag"},
     {"ring.vert", "ring.frag"},
     {"crosshair.vert", "crosshair.frag"}}};

void prepareFramebuffer(const Frame& frame, GLuint framebuffer) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, frame.width, frame.height);
    for (const GLenum capability : {GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_CULL_FACE, GL_FRAMEBUFFER_SRGB,
                                    GL_RASTERIZER_DISCARD, GL_COLOR_LOGIC_OP, GL_BLEND, GL_DEPTH_TEST}) {
        glDisable(capability);
    }
    glEnable(GL_MULTISAMPLE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glLineWidth(1.0f);
    glBlendEquation(GL_FUNC_ADD);
    // The picture stays opaque whatever is drawn over it: the window is put together with others.
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    glClearDepth(1.0);
    glClear(GL_DEPTH_BUFFER_BIT);
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

FrameContext makeContext(const Frame& frame, ProgramCache& programs, GLuint emptyArray) {
    const float aspect = static_cast<float>(frame.width) / static_cast<float>(frame.height);
    FrameContext context{.frame = frame,
                         .colours = themeColours(frame.options.theme),
                         .programs = programs,
                         .emptyArray = emptyArray};
    context.projection = frame.camera.projection(aspect);
    context.viewProjection = context.projection * frame.camera.view();
    context.eye = frame.camera.eye();
    context.forward = frame.camera.forward();
    context.pixelsAtOneMetre =
        0.5f * static_cast<float>(frame.height) / std::tan(0.5f * frame.camera.fieldOfView());
    return context;
}

Status drawFloorAndShades(const FrameContext& context) {
    if (!context.frame.options.floor) {
        return Done{};
    }
    if (Status status = drawFloor(context); !status) {
        return status;
    }
    return context.frame.options.wireframe == WireframeMode::Only ? Status(Done{})
                                                                  : drawContactShades(context);
}

Status drawShaded(const FrameContext& context, DeformationPipeline& pipeline) {
    if (Status status = drawSurfaces(context, pipeline); !status) {
        return status;
    }
    startBlended();
    if (Status status = drawFloorAndShades(context); !status) {
        return status;
    }
    if (Status status = drawTranslucentSurfaces(context, pipeline); !status) {
        return status;
    }
    return context.frame.options.wireframe == WireframeMode::Over
               ? drawEdges(context, pipeline, context.colours.wire, 0.0f)
               : Status(Done{});
}

Status drawWires(const FrameContext& context, DeformationPipeline& pipeline) {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    if (Status status = drawSurfaceDepth(context, pipeline); !status) {
        return status;
    }
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    startBlended();
    if (Status status = drawFloorAndShades(context); !status) {
        return status;
    }
    glm::vec4 colour = context.colours.wireOnly;
    if (Status status = drawEdges(context, pipeline, colour, kSelectedLines); !status) {
        return status;
    }
    colour.a *= kHiddenLines;
    glDepthFunc(GL_GEQUAL);
    Status status = drawEdges(context, pipeline, colour, kSelectedLines);
    glDepthFunc(GL_LESS);
    return status;
}

}  // namespace

struct Renderer::Private {
    ProgramCache programs;
    ProjectilePass projectiles;
    TrailPass trails;
    GhostPass ghost;
    gl::VertexArray emptyArray = gl::VertexArray::make();
    bool software = gl::rendererInfo().isSoftware();
};

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

Status Renderer::draw(const Frame& frame, DeformationPipeline& pipeline, GLuint framebuffer) {
    if (frame.width <= 0 || frame.height <= 0) {
        return Done{};
    }
    const KeepState keep;
    prepareFramebuffer(frame, framebuffer);
    FrameContext context = makeContext(frame, d->programs, d->emptyArray.id());
    context.software = d->software;
    if (Status status = drawBackground(context); !status) {
        return status;
    }
    startSolid();
    if (Status status = d->projectiles.draw(context); !status) {
        return status;
    }
    Status status = frame.options.wireframe == WireframeMode::Only ? drawWires(context, pipeline)
                                                                   : drawShaded(context, pipeline);
    if (!status) {
        return status;
    }
    startBlended();
    if (status = d->trails.draw(context); !status) {
        return status;
    }
    if (status = drawHighlightedHit(context); !status) {
        return status;
    }
    if (status = d->ghost.draw(context); !status) {
        return status;
    }
    return drawCrosshair(context);
}

}  // namespace hitscope
