// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/result.h"
#include "deform/cluster_reach.h"
#include "gl/objects.h"
#include "gl/program.h"
#include "pipeline/hit_arrays.h"
#include "pipeline/target_buffers.h"

namespace hitscope {

/// Vertices that the same hits reach: hits [firstHit, lastHit) of the arrays.
struct CaptureRun {
    std::vector<VertexRange> ranges;
    std::size_t firstHit = 0;
    std::size_t lastHit = 0;
};

/// Deforms vertices of a target's dynamic buffer in a vertex shader and captures them by transform feedback
/// in a scratch buffer, with nothing drawn (paper, section 2.2). A context is current for every call and the
/// destructor.
class CapturePass {
public:
    /// hits > 0: the most that one upload() holds. The error is the driver's.
    [[nodiscard]] static Result<CapturePass> create(std::size_t hits);

    /// The hits that the following run()s apply.
    void upload(const HitArrays& hits);

    /// Told when the vertices of `ranges` lie in the scratch buffer, one range after the other from its
    /// start.
    using Captured = std::function<void(std::span<const VertexRange> ranges)>;
    /// Captures the vertices of all runs, in pieces that the scratch buffer holds; each vertex once. Leaves
    /// the caller's framebuffer, program and vertex array bound.
    void run(const TargetBuffers& buffers, std::span<const CaptureRun> runs, const Captured& captured);

    [[nodiscard]] GLuint scratch() const { return m_scratch.id(); }

private:
    struct Piece {
        const CaptureRun* run = nullptr;
        VertexRange range;
    };
    CapturePass(gl::Program program);
    void reserveScratch(std::size_t vertices);
    void capture(const TargetBuffers& buffers, std::span<const Piece> pieces, std::size_t vertices);

    gl::Program m_program;
    gl::Framebuffer m_framebuffer;
    gl::Renderbuffer m_colour;
    gl::Buffer m_scratch;
    std::size_t m_scratchVertices = 0;
};

}  // namespace hitscope
