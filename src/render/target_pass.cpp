// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/target_pass.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "render/material_set.h"

namespace hitscope::render {
namespace {

constexpr float kRimStrength = 0.75f;
constexpr float kRingWidth = 1.8f;   // logical pixels
constexpr float kLinesAhead = 2.0f;  // pixels' size at their distance: lines lie before the faces they bound

/// A software renderer shades pixels on other processors than it transforms vertices, but starts only when
/// told to, or at the frame's end: told after so many, it does both at once (llvmpipe, 25,000 vertices at
/// 320x180: 8.7 ms a frame against 13.0, in turn).
constexpr std::size_t kFlushVertices = 4096;

const void* indexOffset(std::uint32_t first) {
    return reinterpret_cast<const void*>(std::size_t{first} * sizeof(std::uint32_t));
}

const MaterialSet& materialsOf(const DrawItem& item) {
    static const MaterialSet defaults;
    return item.materials != nullptr ? *item.materials : defaults;
}

void setSurface(const gl::Program& program, const FrameContext& context) {
    const Frame& frame = context.frame;
    setLights(program, context);
    program.set("u_viewProjection", context.viewProjection);
    program.set("u_paperNormals", frame.options.normals == NormalMode::Paper ? 1 : 0);
    program.set("u_ring", frame.highlightedHit
                              ? glm::vec4(frame.highlightedHit->centre, frame.highlightedHit->radius)
                              : glm::vec4(0.0f));
    program.set("u_ringColour", toLinear(context.colours.accent));
    program.set("u_ringWidth", std::max(1.0f, kRingWidth * frame.pixelRatio));
    glActiveTexture(GL_TEXTURE0);
    glBindSampler(0, 0);
}

void prepareSurface(const gl::Program& program, const FrameContext& context, DeformationPipeline& pipeline,
                    const DrawItem& item) {
    pipeline.prepareDraw(program, item.target);
    program.set("u_model", item.model);
    program.set("u_rim", glm::vec4(toLinear(context.colours.accent), item.selected ? kRimStrength : 0.0f));
    glBindVertexArray(item.buffers->surfaceArray());
}

struct Parts {
    bool translucent = false;
    bool textured = false;
};

Status drawParts(const FrameContext& context, DeformationPipeline& pipeline, const Parts& parts) {
    gl::Defines defines = pipeline.drawDefines();
    if (parts.textured) {
        defines.emplace_back("HITSCOPE_TEXTURED", "1");
    }
    const gl::Program* program = nullptr;
    std::size_t waiting = 0;
    for (const DrawItem& item : context.frame.targets) {
        const MaterialSet& materials = materialsOf(item);
        bool prepared = false;
        for (const DrawRange& range : item.buffers->draws()) {
            const bool textured = context.frame.options.textures && materials.isTextured(range.material);
            if (range.count == 0 || textured != parts.textured ||
                materials.isTranslucent(range.material) != parts.translucent) {
                continue;
            }
            if (program == nullptr) {
                const auto found = context.programs.get("surface.vert", "surface.frag", defines);
                if (!found) {
                    return found.error();
                }
                program = found.value();
                program->use();
                setSurface(*program, context);
            }
            if (!prepared) {
                prepareSurface(*program, context, pipeline, item);
                prepared = true;
            }
            materials.apply(*program, range.material);
            glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(range.count), GL_UNSIGNED_INT,
                           indexOffset(range.first));
        }
        waiting += prepared ? item.buffers->vertexCount() : 0;
        if (context.software && waiting > kFlushVertices) {
            glFlush();
            waiting = 0;
        }
    }
    return Done{};
}

}  // namespace

Status drawSurfaces(const FrameContext& context, DeformationPipeline& pipeline) {
    if (Status status = drawParts(context, pipeline, {.translucent = false, .textured = false}); !status) {
        return status;
    }
    return drawParts(context, pipeline, {.translucent = false, .textured = true});
}

Status drawTranslucentSurfaces(const FrameContext& context, DeformationPipeline& pipeline) {
    if (Status status = drawParts(context, pipeline, {.translucent = true, .textured = false}); !status) {
        return status;
    }
    return drawParts(context, pipeline, {.translucent = true, .textured = true});
}

Status drawSurfaceDepth(const FrameContext& context, DeformationPipeline& pipeline) {
    const auto found = context.programs.get("surface.vert", "depth.frag", pipeline.drawDefines());
    if (!found) {
        return found.error();
    }
    const gl::Program& program = *found.value();
    program.use();
    program.set("u_viewProjection", context.viewProjection);
    for (const DrawItem& item : context.frame.targets) {
        pipeline.prepareDraw(program, item.target);
        program.set("u_model", item.model);
        glBindVertexArray(item.buffers->surfaceArray());
        glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(item.buffers->triangleIndexCount()),
                       GL_UNSIGNED_INT, nullptr);
    }
    return Done{};
}

Status drawEdges(const FrameContext& context, DeformationPipeline& pipeline, const glm::vec4& colour,
                 float selectionTint) {
    const auto found = context.programs.get("wire.vert", "wire.frag", pipeline.drawDefines());
    if (!found) {
        return found.error();
    }
    const gl::Program& program = *found.value();
    const Frame& frame = context.frame;
    program.use();
    program.set("u_viewProjection", context.viewProjection);
    program.set("u_depthShift", context.depthPerPixel * kLinesAhead);
    // Wide lines are not for core profiles to draw: on a dense screen each line is drawn side by side
    // instead.
    const int passes = std::clamp(static_cast<int>(std::lround(frame.pixelRatio)), 1, 4);
    const glm::vec4 selected(glm::mix(glm::vec3(colour), context.colours.accent, selectionTint), colour.a);
    for (const DrawItem& item : frame.targets) {
        pipeline.prepareDraw(program, item.target);
        program.set("u_model", item.model);
        program.set("u_colour", item.selected ? selected : colour);
        program.set("u_edgePixels", item.buffers->usualEdge() * context.pixelsAtOneMetre / frame.pixelRatio);
        glBindVertexArray(item.buffers->edgeArray());
        for (int pass = 0; pass < passes; ++pass) {
            const float pixels = static_cast<float>(pass) - 0.5f * static_cast<float>(passes - 1);
            program.set("u_shift", 2.0f * pixels / glm::vec2(frame.width, frame.height));
            glDrawElements(GL_LINES, static_cast<GLsizei>(item.buffers->edgeIndexCount()), GL_UNSIGNED_INT,
                           nullptr);
        }
    }
    return Done{};
}

}  // namespace hitscope::render
