// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <epoxy/gl.h>

namespace hitscope {

/// Puts the caller's bindings and rasterizer state back at the end.
class KeepCaptureState {
public:
    KeepCaptureState() : m_discard(glIsEnabled(GL_RASTERIZER_DISCARD)) {
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &m_framebuffer);
        glGetIntegerv(GL_CURRENT_PROGRAM, &m_program);
        glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &m_vertexArray);
        glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &m_buffer);
    }
    ~KeepCaptureState() {
        if (m_discard == GL_FALSE) {
            glDisable(GL_RASTERIZER_DISCARD);
        }
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(m_framebuffer));
        glUseProgram(static_cast<GLuint>(m_program));
        glBindVertexArray(static_cast<GLuint>(m_vertexArray));
        glBindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(m_buffer));
    }
    KeepCaptureState(const KeepCaptureState&) = delete;
    KeepCaptureState& operator=(const KeepCaptureState&) = delete;

private:
    GLboolean m_discard;
    GLint m_framebuffer = 0;
    GLint m_program = 0;
    GLint m_vertexArray = 0;
    GLint m_buffer = 0;
};

}  // namespace hitscope
