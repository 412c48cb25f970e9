// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <epoxy/gl.h>

#include <array>

namespace hitscope::render {

/// Notes the GL state that drawing a frame changes and gives it back at the end: the window's own painter
/// shares the context.
class KeepState {
public:
    KeepState();
    ~KeepState();
    KeepState(const KeepState&) = delete;
    KeepState& operator=(const KeepState&) = delete;

private:
    struct Capability {
        GLenum name;
        GLboolean on;
    };
    std::array<Capability, 10> m_capabilities;
    GLint m_program = 0;
    GLint m_vertexArray = 0;
    GLint m_arrayBuffer = 0;
    GLint m_drawFramebuffer = 0;
    GLint m_readFramebuffer = 0;
    GLint m_activeTexture = 0;
    std::array<GLint, 2> m_textures{};  ///< of units 0 and 1, 2D
    std::array<GLint, 2> m_samplers{};
    std::array<GLint, 4> m_viewport{};
    std::array<GLint, 4> m_scissor{};
    GLint m_depthFunction = 0;
    GLboolean m_depthMask = GL_TRUE;
    std::array<GLboolean, 4> m_colourMask{};
    std::array<GLint, 4> m_blendFunctions{};  ///< source and destination of colour, of opacity
    std::array<GLint, 2> m_blendEquations{};
    GLfloat m_clearDepth = 1.0f;
    GLfloat m_lineWidth = 1.0f;
};

}  // namespace hitscope::render
