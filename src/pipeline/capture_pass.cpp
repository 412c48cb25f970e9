// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/capture_pass.h"

#include <algorithm>
#include <utility>

#include "pipeline/keep_capture_state.h"
#include "pipeline/vertex_bytes.h"

namespace hitscope {
namespace {

/// Most vertices captured at once (24 MiB), so that one huge hit does not double a huge mesh's memory.
constexpr std::size_t kMostScratchVertices = std::size_t{1} << 20;
constexpr std::size_t kLeastScratchVertices = 4096;

}  // namespace

Result<CapturePass> CapturePass::create(gl::Defines defines) {
    defines.emplace_back("HITSCOPE_OWN_HITS_ONLY", "1");
    Result<gl::Program> program =
        gl::Program::build({"capture.vert", {}, std::move(defines), {"capturedPosition", "capturedNormal"}});
    if (!program) {
        return program.error();
    }
    return CapturePass(std::move(program).value());
}

// Where there is no window there is no default framebuffer, and without a complete framebuffer even a pass
// that draws nothing fails; one pixel of our own makes the pass independent of what the caller has bound.
CapturePass::CapturePass(gl::Program program)
    : m_program(std::move(program)),
      m_clusterBase(m_program.location("u_clusterBase")),
      m_framebuffer(gl::Framebuffer::make()),
      m_colour(gl::Renderbuffer::make()),
      m_scratch(gl::Buffer::make()) {
    const KeepCaptureState keep;
    glBindRenderbuffer(GL_RENDERBUFFER, m_colour.id());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 1, 1);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, m_framebuffer.id());
    glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, m_colour.id());
}

void CapturePass::reserveScratch(std::size_t vertices) {
    if (vertices <= m_scratchVertices) {
        return;
    }
    m_scratchVertices = std::max({vertices, 2 * m_scratchVertices, kLeastScratchVertices});
    m_scratchVertices = std::min(m_scratchVertices, kMostScratchVertices);
    glBindBuffer(GL_COPY_WRITE_BUFFER, m_scratch.id());
    glBufferData(GL_COPY_WRITE_BUFFER, vertexBytes(m_scratchVertices), nullptr, GL_STREAM_COPY);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
}

void CapturePass::run(const TargetBuffers& buffers, std::span<const CaptureRun> runs, const Prepare& prepare,
                      const Captured& captured) {
    std::size_t vertices = 0;
    for (const CaptureRun& run : runs) {
        vertices += run.range.count;
    }
    if (vertices == 0) {
        return;
    }
    const KeepCaptureState keep;
    reserveScratch(vertices);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, m_framebuffer.id());
    glEnable(GL_RASTERIZER_DISCARD);
    m_program.use();
    prepare(m_program);
    glBindVertexArray(buffers.captureArray());
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, m_scratch.id());

    std::vector<CaptureRun> piece;
    std::vector<VertexRange> ranges;
    std::size_t held = 0;
    const auto flush = [&] {
        capture(piece);
        captured(ranges);
        piece.clear();
        ranges.clear();
        held = 0;
    };
    for (CaptureRun rest : runs) {
        while (rest.range.count > 0) {
            const auto room = static_cast<std::uint32_t>(kMostScratchVertices - held);
            const VertexRange range{rest.range.first, std::min(rest.range.count, room)};
            piece.push_back({range, rest.clusterBase});
            if (!ranges.empty() && ranges.back().first + ranges.back().count == range.first) {
                ranges.back().count += range.count;
            } else {
                ranges.push_back(range);
            }
            held += range.count;
            rest.range = {range.first + range.count, rest.range.count - range.count};
            if (held == kMostScratchVertices) {
                flush();
            }
        }
    }
    if (held > 0) {
        flush();
    }
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
}

void CapturePass::capture(std::span<const CaptureRun> runs) {
    glBeginTransformFeedback(GL_POINTS);
    for (const CaptureRun& run : runs) {
        glUniform1i(m_clusterBase, run.clusterBase);
        glDrawArrays(GL_POINTS, static_cast<GLint>(run.range.first), static_cast<GLsizei>(run.range.count));
    }
    glEndTransformFeedback();
}

}  // namespace hitscope
