// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "render/change_map.h"
#include "render/cut_away.h"
#include "render/frame_context.h"
#include "render/line_pass.h"

namespace hitscope::render {
namespace {

struct Style {
    float size;    ///< logical pixels, line included
    float line;    ///< logical pixels
    float fill;    ///< opacity
    float hidden;  ///< opacity where a surface lies before it
};

Style styleOf(MarkKind kind) {
    switch (kind) {
        case MarkKind::Picked:
            return {11.0f, 1.5f, 1.0f, 0.35f};
        case MarkKind::Hovered:
            return {11.0f, 1.5f, 0.0f, 0.35f};
        case MarkKind::Selected:
            break;
    }
    return {4.5f, 0.6f, 1.0f, 0.12f};
}

constexpr float kDotsAhead = 4.0f;  // pixels' size at their distance: dots lie before the faces they stand on

constexpr GLsizei kFewMarks = 300;  // all drawn, however close they lie
constexpr float kApart = 1.0f;      // of a mark's size: closer ones would hide each other

/// So many that they touch where the target is nearest to the eye.
GLsizei shownCount(const FrameContext& context, const VertexMarks& marks, const Style& style) {
    const DrawItem item{.target = marks.target, .buffers = marks.buffers, .model = marks.model};
    const float apart = nearestEdgePixels(context, item) / (kApart * style.size);
    if (marks.count <= kFewMarks || apart >= 1.0f) {
        return marks.count;
    }
    return std::max(kFewMarks, static_cast<GLsizei>(static_cast<float>(marks.count) * apart * apart));
}

void drawMarks(const FrameContext& context, DeformationPipeline& pipeline, const gl::Program& program,
               bool hidden) {
    for (const VertexMarks& marks : context.frame.marks) {
        const Style style = styleOf(marks.kind);
        pipeline.prepareDraw(program, marks.target);
        program.set("u_model", marks.model);
        program.set("u_size", std::round(style.size * context.frame.pixelRatio));
        program.set("u_line", style.line * context.frame.pixelRatio);
        program.set("u_fill", style.fill);
        program.set("u_opacity", hidden ? style.hidden : 1.0f);
        glBindVertexArray(marks.buffers->captureArray());
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, marks.indices);
        glDrawElements(GL_POINTS, shownCount(context, marks, style), GL_UNSIGNED_INT, nullptr);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    }
}

}  // namespace

Status drawVertexMarks(const FrameContext& context, DeformationPipeline& pipeline, MarkPlaces places) {
    if (context.frame.marks.empty()) {
        return Done{};
    }
    gl::Defines defines = targetDefines(context.frame, pipeline);
    if (places == MarkPlaces::Original) {
        defines.emplace_back("HITSCOPE_GHOST", "1");
    }
    const auto found = context.programs.get("mark.vert", "mark.frag", defines);
    if (!found) {
        return found.error();
    }
    const gl::Program& program = *found.value();
    const glm::vec3 line = context.frame.options.theme == Theme::Dark ? glm::vec3(0.0f) : glm::vec3(1.0f);
    program.use();
    program.set("u_viewProjection", context.viewProjection);
    setDrawnPlace(program, context.frame);
    program.set("u_depthShift", context.depthPerPixel * kDotsAhead);
    program.set("u_colour", context.colours.accent);
    program.set("u_lineColour", line);
    const ClipByCut clip(context.frame);
    glEnable(GL_PROGRAM_POINT_SIZE);
    glDepthFunc(GL_GREATER);
    drawMarks(context, pipeline, program, true);
    glDepthFunc(GL_LEQUAL);
    drawMarks(context, pipeline, program, false);
    glDepthFunc(GL_LESS);
    glDisable(GL_PROGRAM_POINT_SIZE);
    return Done{};
}

}  // namespace hitscope::render
