// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/section_pass.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

namespace hitscope::render {
namespace {

constexpr GLuint kPlace = 0;
constexpr float kOriginalWidth = 1.4f;  // logical pixels
constexpr float kDeformedWidth = 2.2f;  // logical pixels
constexpr float kEdge = 0.9f;           // logical pixels
constexpr float kDash = 11.0f;          // logical pixels from one dash to the next, about
constexpr float kHidden = 0.22f;        // opacity behind surfaces
constexpr float kLinesAhead = 4.0f;     // pixels' size at their distance: lines lie before the faces they end
constexpr float kPaneFill = 0.10f;
constexpr float kPaneLine = 0.85f;
constexpr float kPaneWidth = 1.5f;  // logical pixels

/// Each segment's two ends, with the metres along its curve.
void addSegments(std::vector<glm::vec4>& places, const std::vector<SectionCurve>& curves) {
    for (const SectionCurve& curve : curves) {
        const std::size_t count = curve.points.size();
        const std::size_t segments = curve.closed ? count : count - std::min<std::size_t>(count, 1);
        float along = 0.0f;
        for (std::size_t i = 0; i < segments; ++i) {
            const glm::vec3& a = curve.points[i];
            const glm::vec3& b = curve.points[(i + 1) % count];
            places.emplace_back(a, along);
            along += glm::distance(a, b);
            places.emplace_back(b, along);
        }
    }
}

/// Metres; by steps of two, so that dashes do not creep while the camera comes nearer.
float dashLength(const FrameContext& context, const glm::vec3& middle) {
    const float away = std::max(glm::dot(middle - context.eye, context.forward), 1.0e-7f);
    const float metres = kDash * context.frame.pixelRatio / context.pixelsAt(away);
    return std::exp2(std::round(std::log2(std::max(metres, 1.0e-9f))));
}

}  // namespace

SectionPass::SectionPass() {
    for (Uploaded& section : m_uploaded) {
        section.vertices = gl::Buffer::make();
        section.array = gl::VertexArray::make();
        glBindVertexArray(section.array.id());
        glBindBuffer(GL_ARRAY_BUFFER, section.vertices.id());
        glEnableVertexAttribArray(kPlace);
        glVertexAttribPointer(kPlace, 4, GL_FLOAT, GL_FALSE, sizeof(glm::vec4), nullptr);
    }
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void SectionPass::upload(Uploaded& to, const std::shared_ptr<const SectionLines>& lines) const {
    std::vector<glm::vec4> places;
    addSegments(places, lines->original);
    to.original = static_cast<GLsizei>(places.size());
    addSegments(places, lines->deformed);
    to.deformed = static_cast<GLsizei>(places.size()) - to.original;
    Bounds bounds;
    for (const glm::vec4& place : places) {
        bounds.add(glm::vec3(place));
    }
    to.middle = bounds.centre();
    glBindBuffer(GL_ARRAY_BUFFER, to.vertices.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(places.size() * sizeof(glm::vec4)), places.data(),
                 GL_DYNAMIC_DRAW);
    to.lines = lines;
}

const SectionPass::Uploaded& SectionPass::uploaded(const std::shared_ptr<const SectionLines>& lines) {
    if (m_uploaded[m_latest].lines != lines) {
        m_latest = 1 - m_latest;
        if (m_uploaded[m_latest].lines != lines) {
            upload(m_uploaded[m_latest], lines);
        }
    }
    return m_uploaded[m_latest];
}

void SectionPass::drawLines(const FrameContext& context, const gl::Program& program, const Uploaded& section,
                            bool hidden) const {
    const CuttingPlane& cut = context.frame.options.cut;
    const float ratio = context.frame.pixelRatio;
    const float opacity = hidden ? kHidden : 1.0f;
    const auto draw = [&](GLint first, GLsizei count, const glm::vec4& colour, float width, float dash) {
        program.set("u_colour", colour);
        program.set("u_halfWidth", 0.5f * width * ratio);
        program.set("u_reach", (0.5f * width + kEdge) * ratio + 1.0f);
        program.set("u_dash", dash);
        glDrawArrays(GL_LINES, first, count);
    };
    // The deformed one lies over the other where nothing has moved.
    if (cut.originalLine && section.original > 0) {
        draw(0, section.original, glm::vec4(glm::vec3(context.colours.wireOnly), opacity), kOriginalWidth,
             dashLength(context, section.middle));
    }
    if (cut.deformedLine && section.deformed > 0) {
        draw(section.original, section.deformed, glm::vec4(context.colours.accent, opacity), kDeformedWidth,
             0.0f);
    }
}

Status SectionPass::draw(const FrameContext& context) {
    const Frame& frame = context.frame;
    if (!frame.options.cut.on || !frame.section) {
        return Done{};
    }
    const auto found = context.programs.get("section.vert", "section.frag", {}, "section.geom");
    if (!found) {
        return found.error();
    }
    const Uploaded& section = uploaded(frame.section);
    const gl::Program& program = *found.value();
    program.use();
    program.set("u_viewProjection", context.viewProjection);
    program.set("u_depthShift", context.depthPerPixel * kLinesAhead);
    program.set("u_halfSize", 0.5f * glm::vec2(frame.width, frame.height));
    program.set("u_edge", kEdge * frame.pixelRatio);
    program.set("u_edgeColour", frame.options.theme == Theme::Dark ? glm::vec3(0.0f) : glm::vec3(1.0f));
    glBindVertexArray(section.array.id());
    glDepthFunc(GL_GREATER);
    drawLines(context, program, section, true);
    glDepthFunc(GL_LEQUAL);
    drawLines(context, program, section, false);
    glDepthFunc(GL_LESS);
    return Done{};
}

Status drawCutPane(const FrameContext& context) {
    const Frame& frame = context.frame;
    if (!frame.options.cut.on || !frame.showsCutPlane || frame.targets.empty()) {
        return Done{};
    }
    const auto found = context.programs.get("ring.vert", "cut_plane.frag");
    if (!found) {
        return found.error();
    }
    Bounds bounds;
    for (const DrawItem& item : frame.targets) {
        bounds.add(worldBounds(item));
    }
    const PlaneFrame pane = planeFrame(frame.options.cut, bounds);
    const gl::Program& program = *found.value();
    program.use();
    program.set("u_viewProjection", context.viewProjection);
    program.set("u_centre", pane.middle);
    program.set("u_right", pane.right);
    program.set("u_up", pane.up);
    program.set("u_colour", context.colours.accent);
    program.set("u_width", kPaneWidth * frame.pixelRatio);
    glBindVertexArray(context.emptyArray);
    const auto draw = [&program](GLenum depth, float fill, float line) {
        glDepthFunc(depth);
        program.set("u_fill", fill);
        program.set("u_line", line);
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    };
    draw(GL_GREATER, 0.0f, kHidden);
    draw(GL_LESS, kPaneFill, kPaneLine);
    return Done{};
}

}  // namespace hitscope::render
