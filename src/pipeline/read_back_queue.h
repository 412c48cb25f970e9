// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <functional>
#include <span>
#include <vector>

#include "core/ids.h"
#include "deform/vertex_range.h"
#include "gl/objects.h"
#include "mesh/render_mesh.h"

namespace hitscope {

/// Vertices on their way from GPU buffers to the CPU. request() copies them aside on the GPU and returns at
/// once; they can be had when the GPU has come that far, usually a frame or two later. A context is current
/// for every call and the destructor.
class ReadBackQueue {
public:
    ReadBackQueue() = default;
    ~ReadBackQueue();
    ReadBackQueue(const ReadBackQueue&) = delete;
    ReadBackQueue& operator=(const ReadBackQueue&) = delete;

    /// When vertices were asked for, as the pipeline counts its target's hits and what rewrites their past.
    struct Moment {
        std::uint64_t hits = 0;
        std::uint64_t epoch = 0;
    };
    /// Vertices of a target, from a buffer of DynamicVertex.
    struct Part {
        TargetId target;
        GLuint buffer = 0;
        bool packed = false;  ///< they lie in the buffer one range after the other from its start, not each
                              ///< at its place
        std::vector<VertexRange> ranges;
        Moment moment;
    };
    /// Asks for these as they are now.
    void request(std::vector<Part> parts);
    [[nodiscard]] bool empty() const { return m_requests.empty(); }

    using Take =
        std::function<void(const Part& part, std::uint32_t first, std::span<const DynamicVertex> vertices)>;
    /// Hands over what has arrived, in the order it was asked for.
    void takeArrived(const Take& take);
    /// Waits for all of it.
    void takeAll(const Take& take);

private:
    struct Request {
        gl::Buffer staging;
        std::size_t bytes = 0;
        GLsync fence = nullptr;
        std::vector<Part> parts;
    };
    void copyAside(const Part& part, GLintptr& offset);
    [[nodiscard]] static bool hasArrived(const Request& request, GLuint64 timeout);
    void takeFirst(const Take& take);
    [[nodiscard]] Request makeRequest(std::size_t bytes);

    struct Spare {
        gl::Buffer buffer;
        std::size_t bytes = 0;
    };
    std::deque<Request> m_requests;
    std::vector<Spare> m_spares;
    std::vector<DynamicVertex> m_arrived;  ///< of one request; mapped memory may be slow to read twice
};

}  // namespace hitscope
