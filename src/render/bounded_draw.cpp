// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/bounded_draw.h"

#include <algorithm>

namespace hitscope::render {

std::size_t drawBounded(const FrameContext& context, GLenum mode, std::span<const IndexRun> runs,
                        const IndexRun& range) {
    PieceByPiece pieces(context, range.end - range.first);
    IndexRuns piece;
    std::size_t drawn = 0;
    const auto drawPiece = [&] {
        glMultiDrawElements(mode, piece.counts.data(), GL_UNSIGNED_INT, piece.starts.data(),
                            static_cast<GLsizei>(piece.counts.size()));
        pieces.drawn();
        drawn += piece.indices;
        piece = {};
    };
    const auto begin = std::partition_point(runs.begin(), runs.end(),
                                            [&range](const IndexRun& run) { return run.end <= range.first; });
    for (auto run = begin; run != runs.end() && run->first < range.end; ++run) {
        std::uint32_t first = std::max(run->first, range.first);
        const std::uint32_t end = std::min(run->end, range.end);
        while (first < end) {
            const std::uint32_t room = PieceByPiece::kPiece - static_cast<std::uint32_t>(piece.indices);
            const std::uint32_t count = std::min(end - first, room);
            piece.add(first, count);
            first += count;
            if (count == room) {
                drawPiece();
            }
        }
    }
    if (piece.indices > 0) {
        drawPiece();
    }
    return drawn;
}

}  // namespace hitscope::render
