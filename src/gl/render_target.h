// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/image.h"
#include "gl/objects.h"

namespace hitscope::gl {

/// Puts the caller's framebuffer bindings back at the end.
class KeepFramebuffers {
public:
    KeepFramebuffers() {
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &m_draw);
        glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &m_read);
    }
    ~KeepFramebuffers() {
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(m_draw));
        glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(m_read));
    }
    KeepFramebuffers(const KeepFramebuffers&) = delete;
    KeepFramebuffers& operator=(const KeepFramebuffers&) = delete;

private:
    GLint m_draw = 0;
    GLint m_read = 0;
};

/// Reads the colours of a framebuffer without samples, width x height pixels, as rows from top to bottom of
/// blue, green, red and alpha, into 4 * width * height bytes: what windows are made of. Waits for the GPU.
void readBlueFirst(GLuint framebuffer, int width, int height, std::uint8_t* pixels);

/// A framebuffer with an 8-bit RGBA colour buffer and a depth buffer, to draw pictures without a window.
class RenderTarget {
public:
    /// width, height in pixels, > 0. samples: 1, or the number wanted (clamped to what the driver has).
    RenderTarget(int width, int height, int samples = 1);

    /// The most pixels that a side may have here. A context is current.
    [[nodiscard]] static int longestSide();
    /// False where the driver cannot give that much; there is nothing to draw into or read then.
    [[nodiscard]] bool isComplete() const { return m_complete; }
    [[nodiscard]] GLuint framebuffer() const { return m_framebuffer.id(); }
    [[nodiscard]] int width() const { return m_width; }
    [[nodiscard]] int height() const { return m_height; }
    /// Resolves samples and reads the colours; waits for the GPU.
    [[nodiscard]] Image read() const;
    /// Puts its colours into a framebuffer object of that size (0: the default framebuffer), smoothly
    /// enlarged. For one without samples.
    void enlargeInto(GLuint framebuffer, int width, int height) const;

private:
    int m_width = 0;
    int m_height = 0;
    int m_samples = 1;
    bool m_complete = false;
    Framebuffer m_framebuffer;
    Renderbuffer m_colour;
    Renderbuffer m_depth;
};

}  // namespace hitscope::gl
