// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/stream_buffer.h"

namespace hitscope {

StreamBuffer::StreamBuffer(std::size_t elementBytes, std::size_t elements, std::size_t first)
    : m_elementBytes(elementBytes), m_elements(elements), m_next(first), m_buffer(gl::Buffer::make()) {
    glBindBuffer(GL_COPY_WRITE_BUFFER, m_buffer.id());
    glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(elements * elementBytes), nullptr,
                 GL_STREAM_DRAW);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
}

std::size_t StreamBuffer::write(const void* elements, std::size_t count) {
    glBindBuffer(GL_COPY_WRITE_BUFFER, m_buffer.id());
    if (m_next + count > m_elements) {
        glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(m_elements * m_elementBytes), nullptr,
                     GL_STREAM_DRAW);
        m_next = 0;
        ++m_restarts;
    }
    const std::size_t first = m_next;
    glBufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(first * m_elementBytes),
                    static_cast<GLsizeiptr>(count * m_elementBytes), elements);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
    m_next += count;
    return first;
}

}  // namespace hitscope
