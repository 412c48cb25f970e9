// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "gl/objects.h"

namespace hitscope {

/// A buffer of fixed size that takes small arrays, each behind the one before, so that the GPU may still be
/// reading those. Full, it starts over in fresh memory. A context is current for every call and the
/// destructor.
class StreamBuffer {
public:
    /// Room for `elements` of `elementBytes` each.
    StreamBuffer(std::size_t elementBytes, std::size_t elements);

    /// Puts in `count` elements, as many as there is room for in all at most; returns the index of the first.
    std::size_t write(const void* elements, std::size_t count);
    [[nodiscard]] GLuint id() const { return m_buffer.id(); }

private:
    std::size_t m_elementBytes;
    std::size_t m_elements;
    std::size_t m_next;
    gl::Buffer m_buffer;
};

}  // namespace hitscope
