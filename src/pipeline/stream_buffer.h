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
    /// Room for `elements` of `elementBytes` each; the first go to index `first`.
    StreamBuffer(std::size_t elementBytes, std::size_t elements, std::size_t first = 0);

    /// Puts in `count` elements, as many as there is room for in all at most; returns the index of the first.
    std::size_t write(const void* elements, std::size_t count);
    [[nodiscard]] GLuint id() const { return m_buffer.id(); }
    /// How often it has started over. A texture of it has to be attached again then: Mesa's softpipe goes on
    /// reading the memory before.
    [[nodiscard]] std::size_t restarts() const { return m_restarts; }

private:
    std::size_t m_elementBytes;
    std::size_t m_elements;
    std::size_t m_next;
    std::size_t m_restarts = 0;
    gl::Buffer m_buffer;
};

}  // namespace hitscope
