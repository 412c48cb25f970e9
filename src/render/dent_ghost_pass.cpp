// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/dent_ghost_pass.h"

#include <algorithm>

namespace hitscope::render {
namespace {

constexpr GLuint kGhostPosition = 0;
constexpr float kFill = 0.30f;
constexpr float kLine = 0.85f;
constexpr float kWidth = 1.2f;      // logical pixels
constexpr double kNearest = 0.001;  // of the depth range: before everything that has been drawn

}  // namespace

DentGhostPass::DentGhostPass() : m_vertices(gl::Buffer::make()), m_array(gl::VertexArray::make()) {
    glBindVertexArray(m_array.id());
    glBindBuffer(GL_ARRAY_BUFFER, m_vertices.id());
    glEnableVertexAttribArray(kGhostPosition);
    glVertexAttribPointer(kGhostPosition, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

Status DentGhostPass::draw(const FrameContext& context) {
    const auto& ghost = context.frame.ghost;
    if (!ghost || ghost->empty()) {
        return Done{};
    }
    gl::Defines defines;
    addSight(defines, context.frame);
    const auto found = context.programs.get("dent_ghost.vert", "dent_ghost.frag", defines);
    if (!found) {
        return found.error();
    }
    glBindVertexArray(m_array.id());
    if (ghost != m_uploaded) {
        glBindBuffer(GL_ARRAY_BUFFER, m_vertices.id());
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(ghost->size() * sizeof(glm::vec3)),
                     ghost->data(), GL_DYNAMIC_DRAW);
        m_uploaded = ghost;
    }
    const gl::Program& program = *found.value();
    program.use();
    program.set("u_viewProjection", context.viewProjection);
    program.set("u_eye", context.eye);
    setSight(program, context.frame);
    program.set("u_colour", context.colours.accent);
    program.set("u_fill", kFill);
    program.set("u_line", kLine);
    program.set("u_width", std::max(1.0f, kWidth * context.frame.pixelRatio));
    // A dent lies behind the surface that it will be made in: it shows through it, but not through itself.
    const auto count = static_cast<GLsizei>(ghost->size());
    glDepthRange(0.0, kNearest);
    glDepthMask(GL_TRUE);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDrawArrays(GL_TRIANGLES, 0, count);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_LEQUAL);
    glDrawArrays(GL_TRIANGLES, 0, count);
    glDepthFunc(GL_LESS);
    glDepthRange(0.0, 1.0);
    return Done{};
}

}  // namespace hitscope::render
