// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/result.h"
#include "deform/vertex_range.h"
#include "gl/objects.h"
#include "gl/program.h"
#include "pipeline/target_buffers.h"

namespace hitscope {

/// Vertices to capture, and u_clusterBase of hits.glsl for them (where hits come in lists).
struct CaptureRun {
    VertexRange range;
    int clusterBase = 0;
};

/// Deforms vertices of a target's dynamic buffer in a vertex shader and captures them by transform feedback
/// in a scratch buffer, with nothing drawn (paper, section 2.2). A context is current for every call and the
/// destructor.
class CapturePass {
public:
    /// `defines` say where the hits are, see hits.glsl. The error is the driver's.
    [[nodiscard]] static Result<CapturePass> create(gl::Defines defines);

    /// Called with the program in use: brings it its hits.
    using Prepare = std::function<void(const gl::Program& program)>;
    /// Told when the vertices of `ranges` lie in the scratch buffer, one range after the other from its
    /// start.
    using Captured = std::function<void(std::span<const VertexRange> ranges)>;
    /// Captures the vertices of all runs (ascending), in pieces that the scratch buffer holds; each vertex
    /// once. Leaves the caller's framebuffer, program and vertex array bound.
    void run(const TargetBuffers& buffers, std::span<const CaptureRun> runs, const Prepare& prepare,
             const Captured& captured);

    [[nodiscard]] GLuint scratch() const { return m_scratch.id(); }

private:
    explicit CapturePass(gl::Program program);
    void reserveScratch(std::size_t vertices);
    void capture(std::span<const CaptureRun> runs);

    gl::Program m_program;
    GLint m_clusterBase;
    gl::Framebuffer m_framebuffer;
    gl::Renderbuffer m_colour;
    gl::Buffer m_scratch;
    std::size_t m_scratchVertices = 0;
};

}  // namespace hitscope
