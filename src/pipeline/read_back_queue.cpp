// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/read_back_queue.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "pipeline/vertex_bytes.h"

namespace hitscope {

namespace {

constexpr std::size_t kLeastBytes = std::size_t{64} << 10;
constexpr std::size_t kSpares = 32;  // a scene's targets, or as many frames
constexpr std::size_t kMostSpareBytes = std::size_t{8} << 20;
constexpr GLuint64 kOneSecond = 1'000'000'000;

}  // namespace

ReadBackQueue::~ReadBackQueue() {
    for (const Request& request : m_requests) {
        glDeleteSync(request.fence);
    }
}

ReadBackQueue::Request ReadBackQueue::makeRequest(std::size_t bytes) {
    const auto spare = std::find_if(m_spares.begin(), m_spares.end(),
                                    [bytes](const Spare& candidate) { return candidate.bytes >= bytes; });
    Request request;
    if (spare != m_spares.end()) {
        request.staging = std::move(spare->buffer);
        request.bytes = spare->bytes;
        m_spares.erase(spare);
        return request;
    }
    request.staging = gl::Buffer::make();
    request.bytes = std::bit_ceil(std::max(bytes, kLeastBytes));
    glBindBuffer(GL_COPY_WRITE_BUFFER, request.staging.id());
    glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(request.bytes), nullptr, GL_STREAM_READ);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
    return request;
}

void ReadBackQueue::copyAside(const Part& part, GLintptr& offset) {
    glBindBuffer(GL_COPY_READ_BUFFER, part.buffer);
    GLintptr packed = 0;
    for (const VertexRange& range : part.ranges) {
        const GLsizeiptr bytes = vertexBytes(range.count);
        const auto place = part.packed ? packed : vertexBytes(range.first);
        glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, place, offset, bytes);
        packed += bytes;
        offset += bytes;
    }
}

void ReadBackQueue::request(std::vector<Part> parts) {
    std::size_t vertices = 0;
    for (const Part& part : parts) {
        vertices += vertexCount(part.ranges);
    }
    if (vertices == 0) {
        return;
    }
    Request made = makeRequest(static_cast<std::size_t>(vertexBytes(vertices)));
    glBindBuffer(GL_COPY_WRITE_BUFFER, made.staging.id());
    GLintptr offset = 0;
    for (const Part& part : parts) {
        copyAside(part, offset);
    }
    glBindBuffer(GL_COPY_READ_BUFFER, 0);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
    made.parts = std::move(parts);
    made.fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    m_requests.push_back(std::move(made));
}

bool ReadBackQueue::hasArrived(const Request& request, GLuint64 timeout) {
    return glClientWaitSync(request.fence, GL_SYNC_FLUSH_COMMANDS_BIT, timeout) != GL_TIMEOUT_EXPIRED;
}

void ReadBackQueue::takeArrived(const Take& take) {
    while (!m_requests.empty() && hasArrived(m_requests.front(), 0)) {
        takeFirst(take);
    }
}

void ReadBackQueue::takeAll(const Take& take) {
    while (!m_requests.empty()) {
        if (hasArrived(m_requests.front(), kOneSecond)) {
            takeFirst(take);
        }
    }
}

void ReadBackQueue::takeFirst(const Take& take) {
    Request request = std::move(m_requests.front());
    m_requests.pop_front();
    glDeleteSync(request.fence);
    std::size_t vertices = 0;
    for (const Part& part : request.parts) {
        vertices += vertexCount(part.ranges);
    }
    glBindBuffer(GL_COPY_READ_BUFFER, request.staging.id());
    const auto* mapped = static_cast<const DynamicVertex*>(
        glMapBufferRange(GL_COPY_READ_BUFFER, 0, vertexBytes(vertices), GL_MAP_READ_BIT));
    m_arrived.clear();
    if (mapped != nullptr) {
        m_arrived.assign(mapped, mapped + vertices);
        glUnmapBuffer(GL_COPY_READ_BUFFER);
    }
    glBindBuffer(GL_COPY_READ_BUFFER, 0);
    std::span<const DynamicVertex> rest(m_arrived);
    for (const Part& part : request.parts) {
        for (const VertexRange& range : part.ranges) {
            if (rest.size() < range.count) {
                return;  // the context is lost, and everything is made again with a new one
            }
            take(part, range.first, rest.first(range.count));
            rest = rest.subspan(range.count);
        }
    }
    if (m_spares.size() < kSpares && request.bytes <= kMostSpareBytes) {
        m_spares.push_back({std::move(request.staging), request.bytes});
    }
}

}  // namespace hitscope
