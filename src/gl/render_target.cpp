// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/render_target.h"

#include <algorithm>

namespace hitscope::gl {
namespace {

Renderbuffer makeStorage(GLenum format, int samples, int width, int height) {
    Renderbuffer storage = Renderbuffer::make();
    glBindRenderbuffer(GL_RENDERBUFFER, storage.id());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples > 1 ? samples : 0, format, width, height);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    return storage;
}

int clampSamples(int samples) {
    GLint most = 1;
    glGetIntegerv(GL_MAX_SAMPLES, &most);
    return std::clamp(samples, 1, std::max(most, 1));
}

/// OpenGL's first row is the lowest; a picture's is the highest.
void flipRows(std::uint8_t* pixels, int width, int height) {
    const std::ptrdiff_t row = 4 * static_cast<std::ptrdiff_t>(width);
    for (int y = 0; y < height / 2; ++y) {
        std::swap_ranges(pixels + y * row, pixels + (y + 1) * row, pixels + (height - 1 - y) * row);
    }
}

}  // namespace

RenderTarget::RenderTarget(int width, int height, int samples)
    : m_width(width),
      m_height(height),
      m_samples(clampSamples(samples)),
      m_framebuffer(Framebuffer::make()),
      m_colour(makeStorage(GL_RGBA8, m_samples, width, height)),
      m_depth(makeStorage(GL_DEPTH24_STENCIL8, m_samples, width, height)) {
    const KeepFramebuffers keep;
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.id());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, m_colour.id());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, m_depth.id());
    m_complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

int RenderTarget::longestSide() {
    GLint storage = 0;
    GLint viewport[2] = {0, 0};
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &storage);
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
    return std::min({storage, viewport[0], viewport[1]});
}

Image RenderTarget::read() const {
    const KeepFramebuffers keep;
    Framebuffer resolved;
    Renderbuffer colour;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, m_framebuffer.id());
    if (m_samples > 1) {
        resolved = Framebuffer::make();
        colour = makeStorage(GL_RGBA8, 1, m_width, m_height);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved.id());
        glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour.id());
        glBlitFramebuffer(0, 0, m_width, m_height, 0, 0, m_width, m_height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved.id());
    }
    Image image;
    image.width = m_width;
    image.height = m_height;
    image.pixels.resize(4 * static_cast<std::size_t>(m_width) * static_cast<std::size_t>(m_height));
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, m_width, m_height, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
    flipRows(image.pixels.data(), m_width, m_height);
    return image;
}

void readBlueFirst(GLuint framebuffer, int width, int height, std::uint8_t* pixels) {
    const KeepFramebuffers keep;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width, height, GL_BGRA, GL_UNSIGNED_BYTE, pixels);
    flipRows(pixels, width, height);
}

void RenderTarget::enlargeInto(GLuint framebuffer, int width, int height) const {
    const KeepFramebuffers keep;
    const bool limited = glIsEnabled(GL_SCISSOR_TEST) == GL_TRUE;  // it would limit the copy too
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, m_framebuffer.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glBlitFramebuffer(0, 0, m_width, m_height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    if (limited) {
        glEnable(GL_SCISSOR_TEST);
    }
}

}  // namespace hitscope::gl
