// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/stream_texture.h"

namespace hitscope {

namespace {

constexpr std::size_t kLate = 64;  // elements before the end

}  // namespace

StreamTexture::StreamTexture(GLenum format, std::size_t elementBytes, std::size_t elements, bool startsLate)
    : m_format(format),
      m_buffer(elementBytes, elements, startsLate ? elements - kLate : 0),
      m_texture(gl::Texture::make()) {
    attach();
}

void StreamTexture::attach() {
    glBindTexture(GL_TEXTURE_BUFFER, m_texture.id());
    glTexBuffer(GL_TEXTURE_BUFFER, m_format, m_buffer.id());
    glBindTexture(GL_TEXTURE_BUFFER, 0);
    m_attachedAt = m_buffer.restarts();
}

std::size_t StreamTexture::write(const void* elements, std::size_t count) {
    const std::size_t first = m_buffer.write(elements, count);
    if (m_buffer.restarts() != m_attachedAt) {
        attach();
    }
    return first;
}

void StreamTexture::bind(GLint unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_BUFFER, m_texture.id());
}

}  // namespace hitscope
