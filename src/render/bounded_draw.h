// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <epoxy/gl.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

#include "render/frame_context.h"
#include "render/index_runs.h"

namespace hitscope::render {

/// A software renderer keeps what it has transformed until it is shaded, some hundred bytes a triangle, and
/// transforms as far ahead as it gets: with millions of triangles that is more than the mesh. So it gets
/// these in pieces, and waits for the last piece but one.
class PieceByPiece {
public:
    static constexpr std::uint32_t kPiece = 3 << 16;  ///< indices; whole triangles and whole lines

    /// all: indices that are going to be drawn.
    PieceByPiece(const FrameContext& context, std::size_t all) : m_waits(context.software && all > kPiece) {}
    ~PieceByPiece() { glDeleteSync(m_before); }
    PieceByPiece(const PieceByPiece&) = delete;
    PieceByPiece& operator=(const PieceByPiece&) = delete;

    /// Indices of the next piece, of so many that are left.
    [[nodiscard]] std::uint32_t next(std::uint32_t left) const {
        return m_waits ? std::min(left, kPiece) : left;
    }
    /// One was.
    void drawn() {
        constexpr GLuint64 kPatience = 1'000'000'000;  // nanoseconds
        if (!m_waits) {
            return;
        }
        const GLsync now = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
        glFlush();
        if (const GLsync before = std::exchange(m_before, now)) {
            glClientWaitSync(before, 0, kPatience);
            glDeleteSync(before);
        }
    }

private:
    bool m_waits;
    GLsync m_before = nullptr;
};

/// glDrawElements() of so many indices of the bound vertex array, from its `first`; piece by piece.
inline void drawBounded(const FrameContext& context, GLenum mode, std::uint32_t first, std::uint32_t count) {
    PieceByPiece pieces(context, count);
    for (std::uint32_t done = 0; done < count;) {
        const std::uint32_t piece = pieces.next(count - done);
        const auto* const offset =
            reinterpret_cast<const void*>(sizeof(std::uint32_t) * (std::size_t{first} + done));
        glDrawElements(mode, static_cast<GLsizei>(piece), GL_UNSIGNED_INT, offset);
        done += piece;
        pieces.drawn();
    }
}

/// glMultiDrawElements() of what the runs have in the range of the bound vertex array; piece by piece.
/// Returns how many indices that are.
std::size_t drawBounded(const FrameContext& context, GLenum mode, std::span<const IndexRun> runs,
                        const IndexRun& range);

}  // namespace hitscope::render
