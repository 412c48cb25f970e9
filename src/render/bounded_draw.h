// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/frame_context.h"
#include "render/index_runs.h"

namespace hitscope::render {

/// Whether what lies behind must be drawn before what lies in front of it.
enum class DrawOrder : std::uint8_t { AsGiven, Any };

/// What runs have in a range of an index buffer, in pieces for a software renderer. Such a renderer keeps
/// what it has transformed until it is shaded, some hundred bytes a triangle, and transforms as far ahead as
/// it gets: with millions of triangles that is more than the mesh. Its threads share a piece by tiles of the
/// picture, so in any order a piece has triangles from several places of the mesh.
class DrawPieces {
public:
    static constexpr std::uint32_t kMost = 3 << 16;  ///< indices of a piece

    /// Triangles or lines, whose indices begin at the range's first. `runs` outlives this.
    DrawPieces(std::span<const IndexRun> runs, const IndexRun& range, DrawOrder order);

    /// Empty: there are no more.
    [[nodiscard]] IndexRuns next();

private:
    /// A part of the range.
    struct Strand {
        std::span<const IndexRun>::iterator run;  ///< that has the next index, or ends before it
        std::uint32_t next;
        std::uint32_t end;
    };
    /// Moves up to so many indices to the piece.
    void take(Strand& strand, std::uint32_t most, IndexRuns& piece) const;

    std::span<const IndexRun> m_runs;
    std::vector<Strand> m_strands;  ///< that have not come to their ends
};

/// glMultiDrawElements() of the bound vertex array. Returns how many indices that are.
std::size_t drawRuns(GLenum mode, std::span<const IndexRun> runs);

/// glMultiDrawElements() of what the runs have in the range of the bound vertex array; a software renderer
/// gets much in pieces (DrawPieces), and waits for the last piece but one. Returns how many indices that are.
std::size_t drawBounded(const FrameContext& context, GLenum mode, std::span<const IndexRun> runs,
                        const IndexRun& range, DrawOrder order);

/// The same with all indices of the range.
std::size_t drawBounded(const FrameContext& context, GLenum mode, const IndexRun& range, DrawOrder order);

}  // namespace hitscope::render
