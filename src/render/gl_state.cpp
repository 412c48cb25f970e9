// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gl_state.h"

namespace hitscope::render {

KeepState::KeepState()
    : m_capabilities{{{GL_DEPTH_TEST, 0},
                      {GL_BLEND, 0},
                      {GL_CULL_FACE, 0},
                      {GL_SCISSOR_TEST, 0},
                      {GL_STENCIL_TEST, 0},
                      {GL_MULTISAMPLE, 0},
                      {GL_FRAMEBUFFER_SRGB, 0},
                      {GL_RASTERIZER_DISCARD, 0},
                      {GL_COLOR_LOGIC_OP, 0},
                      {GL_PROGRAM_POINT_SIZE, 0}}} {
    for (Capability& capability : m_capabilities) {
        capability.on = glIsEnabled(capability.name);
    }
    glGetIntegerv(GL_CURRENT_PROGRAM, &m_program);
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &m_vertexArray);
    glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &m_arrayBuffer);
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &m_drawFramebuffer);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &m_readFramebuffer);
    glGetIntegerv(GL_ACTIVE_TEXTURE, &m_activeTexture);
    for (std::size_t unit = 0; unit < m_textures.size(); ++unit) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        glGetIntegerv(GL_TEXTURE_BINDING_2D, &m_textures[unit]);
        glGetIntegerv(GL_SAMPLER_BINDING, &m_samplers[unit]);
    }
    glActiveTexture(GL_TEXTURE0);
    glGetIntegerv(GL_VIEWPORT, m_viewport.data());
    glGetIntegerv(GL_SCISSOR_BOX, m_scissor.data());
    glGetIntegerv(GL_DEPTH_FUNC, &m_depthFunction);
    glGetBooleanv(GL_DEPTH_WRITEMASK, &m_depthMask);
    glGetBooleanv(GL_COLOR_WRITEMASK, m_colourMask.data());
    glGetIntegerv(GL_BLEND_SRC_RGB, &m_blendFunctions[0]);
    glGetIntegerv(GL_BLEND_DST_RGB, &m_blendFunctions[1]);
    glGetIntegerv(GL_BLEND_SRC_ALPHA, &m_blendFunctions[2]);
    glGetIntegerv(GL_BLEND_DST_ALPHA, &m_blendFunctions[3]);
    glGetIntegerv(GL_BLEND_EQUATION_RGB, &m_blendEquations[0]);
    glGetIntegerv(GL_BLEND_EQUATION_ALPHA, &m_blendEquations[1]);
    glGetFloatv(GL_DEPTH_CLEAR_VALUE, &m_clearDepth);
    glGetFloatv(GL_LINE_WIDTH, &m_lineWidth);
}

KeepState::~KeepState() {
    for (const Capability& capability : m_capabilities) {
        if (capability.on != GL_FALSE) {
            glEnable(capability.name);
        } else {
            glDisable(capability.name);
        }
    }
    glUseProgram(static_cast<GLuint>(m_program));
    glBindVertexArray(static_cast<GLuint>(m_vertexArray));
    glBindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(m_arrayBuffer));
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(m_drawFramebuffer));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(m_readFramebuffer));
    for (std::size_t unit = 0; unit < m_textures.size(); ++unit) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(m_textures[unit]));
        glBindSampler(static_cast<GLuint>(unit), static_cast<GLuint>(m_samplers[unit]));
    }
    glActiveTexture(static_cast<GLenum>(m_activeTexture));
    glViewport(m_viewport[0], m_viewport[1], m_viewport[2], m_viewport[3]);
    glScissor(m_scissor[0], m_scissor[1], m_scissor[2], m_scissor[3]);
    glDepthFunc(static_cast<GLenum>(m_depthFunction));
    glDepthMask(m_depthMask);
    glColorMask(m_colourMask[0], m_colourMask[1], m_colourMask[2], m_colourMask[3]);
    glBlendFuncSeparate(static_cast<GLenum>(m_blendFunctions[0]), static_cast<GLenum>(m_blendFunctions[1]),
                        static_cast<GLenum>(m_blendFunctions[2]), static_cast<GLenum>(m_blendFunctions[3]));
    glBlendEquationSeparate(static_cast<GLenum>(m_blendEquations[0]),
                            static_cast<GLenum>(m_blendEquations[1]));
    glClearDepth(static_cast<GLdouble>(m_clearDepth));
    glLineWidth(m_lineWidth);
}

}  // namespace hitscope::render
