// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/undo_ring.h"

#include <algorithm>
#include <utility>

#include "mesh/render_mesh.h"
#include "pipeline/vertex_bytes.h"

namespace hitscope {

namespace {

constexpr std::uint64_t kRingBytes = std::uint64_t{8} << 20;  // about 800 of the paper's hits
constexpr std::uint64_t kMostEntryBytes = kRingBytes / 4;

}  // namespace

bool UndoRing::isKept(const Entry& entry) const {
    return m_end - entry.start <= kRingBytes;
}

void UndoRing::reserve() {
    if (!m_buffer) {
        m_buffer = gl::Buffer::make();
        glBindBuffer(GL_COPY_WRITE_BUFFER, m_buffer.id());
        glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(kRingBytes), nullptr, GL_DYNAMIC_COPY);
    } else {
        glBindBuffer(GL_COPY_WRITE_BUFFER, m_buffer.id());
    }
}

void UndoRing::save(TargetId target, GLuint buffer, std::size_t firstHit, std::vector<VertexRange> ranges) {
    std::deque<Entry>& entries = m_entries[target];
    const auto bytes = static_cast<std::uint64_t>(vertexBytes(vertexCount(ranges)));
    if (bytes > kMostEntryBytes) {
        entries.clear();  // without this one, older ones lead nowhere
        return;
    }
    if (m_end % kRingBytes + bytes > kRingBytes) {
        m_end += kRingBytes - m_end % kRingBytes;  // an entry lies in one piece
    }
    reserve();
    glBindBuffer(GL_COPY_READ_BUFFER, buffer);
    auto offset = static_cast<GLintptr>(m_end % kRingBytes);
    for (const VertexRange& range : ranges) {
        glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, vertexBytes(range.first), offset,
                            vertexBytes(range.count));
        offset += vertexBytes(range.count);
    }
    glBindBuffer(GL_COPY_READ_BUFFER, 0);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
    entries.push_back({firstHit, std::move(ranges), m_end});
    m_end += bytes;
    while (!isKept(entries.front())) {
        entries.pop_front();
    }
}

std::optional<std::size_t> UndoRing::reachableBefore(TargetId target, std::size_t hit) const {
    const auto entries = m_entries.find(target);
    if (entries == m_entries.end()) {
        return std::nullopt;
    }
    for (auto entry = entries->second.rbegin(); entry != entries->second.rend() && isKept(*entry); ++entry) {
        if (entry->firstHit <= hit) {
            return entry->firstHit;
        }
    }
    return std::nullopt;
}

std::vector<VertexRange> UndoRing::goBack(TargetId target, GLuint buffer, std::size_t firstHit) {
    std::deque<Entry>& entries = m_entries[target];
    std::vector<VertexRange> written;
    glBindBuffer(GL_COPY_READ_BUFFER, m_buffer.id());
    glBindBuffer(GL_COPY_WRITE_BUFFER, buffer);
    while (!entries.empty() && entries.back().firstHit >= firstHit) {
        const Entry& entry = entries.back();
        auto offset = static_cast<GLintptr>(entry.start % kRingBytes);
        for (const VertexRange& range : entry.ranges) {
            glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, offset, vertexBytes(range.first),
                                vertexBytes(range.count));
            offset += vertexBytes(range.count);
        }
        written.insert(written.end(), entry.ranges.begin(), entry.ranges.end());
        entries.pop_back();
    }
    glBindBuffer(GL_COPY_READ_BUFFER, 0);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
    return merged(std::move(written));
}

}  // namespace hitscope
