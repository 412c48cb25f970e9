// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/shrunk.h"

#include "gl/objects.h"
#include "gl/render_target.h"

namespace hitscope::gl {

namespace {

/// A texture with room for a picture and its mipmaps, and a framebuffer to draw into its levels.
struct Steps {
    Texture texture = Texture::make();
    Framebuffer framebuffer = Framebuffer::make();

    void attach(GLenum target, int level) const {
        glBindFramebuffer(target, framebuffer.id());
        glFramebufferTexture2D(target, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.id(), level);
    }
};

class KeepTexture {
public:
    KeepTexture() { glGetIntegerv(GL_TEXTURE_BINDING_2D, &m_texture); }
    ~KeepTexture() { glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(m_texture)); }
    KeepTexture(const KeepTexture&) = delete;
    KeepTexture& operator=(const KeepTexture&) = delete;

private:
    GLint m_texture = 0;
};

}  // namespace

Image shrunk(GLuint framebuffer, int width, int height, int toWidth, int toHeight) {
    const KeepFramebuffers keep;
    const KeepTexture keepTexture;
    const RenderTarget small(toWidth, toHeight);
    const Steps steps;
    glBindTexture(GL_TEXTURE_2D, steps.texture.id());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    // Samples are resolved at their own size only.
    steps.attach(GL_DRAW_FRAMEBUFFER, 0);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    int level = 0;
    int w = width;
    int h = height;
    for (; w / 2 >= toWidth && h / 2 >= toHeight; ++level) {
        w /= 2;
        h /= 2;
    }
    if (level > 0) {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, level);
        glGenerateMipmap(GL_TEXTURE_2D);
    }
    steps.attach(GL_READ_FRAMEBUFFER, level);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, small.framebuffer());
    glBlitFramebuffer(0, 0, w, h, 0, 0, toWidth, toHeight, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    return small.read();
}

}  // namespace hitscope::gl
