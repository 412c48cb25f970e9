// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/stream_buffer.h"

namespace hitscope {

/// A StreamBuffer that shaders read as a buffer texture. A context is current for every call and the
/// destructor.
class StreamTexture {
public:
    /// `format`: GL_RGBA32F and the like. Room for `elements` of `elementBytes` each. `startsLate`: the first
    /// go near the end.
    StreamTexture(GLenum format, std::size_t elementBytes, std::size_t elements, bool startsLate);

    /// As StreamBuffer::write().
    std::size_t write(const void* elements, std::size_t count);
    /// To a texture unit, which is then the active one.
    void bind(GLint unit) const;

private:
    void attach();

    GLenum m_format;
    StreamBuffer m_buffer;
    gl::Texture m_texture;
    std::size_t m_attachedAt = 0;  ///< StreamBuffer::restarts()
};

}  // namespace hitscope
