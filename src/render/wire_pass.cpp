// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/wire_pass.h"

#include <glm/common.hpp>

#include "render/change_map.h"
#include "render/cut_away.h"
#include "render/early_start.h"
#include "render/line_pass.h"
#include "render/target_pass.h"

namespace hitscope::render {

namespace {

constexpr float kSelectedLines = 0.7f;  // of the accent colour, where lines are all there is to a target
constexpr float kHiddenLines = 0.16f;   // opacity of lines behind a surface, of that of the others
constexpr float kLeastHiddenEdge =
    3.0f;  // logical pixels: shorter ones cannot be seen through what is before

glm::vec4 colourOf(const FrameContext& context, const DrawItem& item) {
    const glm::vec4& colour = context.colours.wireOnly;
    const float tint = item.selected ? kSelectedLines : 0.0f;
    return {glm::mix(glm::vec3(colour), context.colours.accent, tint), colour.a};
}

/// One pass over the surface instead of one for its depth and one for lines that nobody can tell apart.
Status fillDense(const FrameContext& context, DeformationPipeline& pipeline) {
    const ClipByCut clip(context.frame);
    const gl::Program* program = nullptr;
    EarlyStart earlyStart(context);
    for (const DrawItem& item : context.frame.targets) {
        if (nearestEdgePixels(context, item) >= kLeastEdge || !context.mayShow(item, pipeline)) {
            continue;
        }
        if (program == nullptr) {
            gl::Defines defines = targetDefines(context.frame, pipeline);
            addSight(defines, context.frame);
            if (context.frame.options.normals == NormalMode::Paper) {
                defines.emplace_back("HITSCOPE_PAPER_NORMALS", "1");
            }
            const auto found = context.programs.get("surface.vert", "dense_wire.frag", defines);
            if (!found) {
                return found.error();
            }
            program = found.value();
            program->use();
            program->set("u_viewProjection", context.viewProjection);
            program->set("u_eye", context.eye);
            setSight(*program, context.frame);
            setDrawnPlace(*program, context.frame);
        }
        pipeline.prepareDraw(*program, item.target);
        program->set("u_model", item.model);
        program->set("u_colour", colourOf(context, item));
        program->set("u_edgePixels",
                     item.buffers->usualEdge() * context.pixelsAt(1.0f) / context.frame.pixelRatio);
        glBindVertexArray(item.original ? item.buffers->originalSurfaceArray()
                                        : item.buffers->surfaceArray());
        glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(item.buffers->triangleIndexCount()),
                       GL_UNSIGNED_INT, nullptr);
        earlyStart.drawn(item.buffers->vertexCount());
    }
    return Done{};
}

}  // namespace

Status drawWireSurfaces(const FrameContext& context, DeformationPipeline& pipeline) {
    if (Status status = fillDense(context, pipeline); !status) {
        return status;
    }
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    Status status = drawSurfaceDepth(context, pipeline, context.viewProjection, DepthOf::Seen, kLeastEdge);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    return status;
}

Status drawWireLines(const FrameContext& context, DeformationPipeline& pipeline) {
    EdgeStyle style{
        .colour = context.colours.wireOnly, .selectionTint = kSelectedLines, .leastPixels = kLeastEdge};
    if (Status status = drawEdges(context, pipeline, style); !status) {
        return status;
    }
    style.colour.a *= kHiddenLines;
    style.leastPixels = kLeastHiddenEdge;
    style.faint = true;
    glDepthFunc(GL_GEQUAL);
    Status status = drawEdges(context, pipeline, style);
    glDepthFunc(GL_LESS);
    return status;
}

}  // namespace hitscope::render
