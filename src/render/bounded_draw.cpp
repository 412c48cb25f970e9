// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/bounded_draw.h"

#include <algorithm>
#include <utility>

namespace hitscope::render {
namespace {

constexpr std::uint32_t kWhole = 6;  // indices: triangles and lines end there
constexpr std::uint32_t kStrands = 8;

/// Waits for what was drawn before the last piece.
class WaitForLastButOne {
public:
    WaitForLastButOne() = default;
    ~WaitForLastButOne() { glDeleteSync(m_before); }
    WaitForLastButOne(const WaitForLastButOne&) = delete;
    WaitForLastButOne& operator=(const WaitForLastButOne&) = delete;

    void drawn() {
        constexpr GLuint64 kPatience = 1'000'000'000;  // nanoseconds
        const GLsync now = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
        glFlush();
        if (const GLsync before = std::exchange(m_before, now)) {
            glClientWaitSync(before, 0, kPatience);
            glDeleteSync(before);
        }
    }

private:
    GLsync m_before = nullptr;
};

void draw(GLenum mode, const IndexRuns& runs) {
    if (runs.counts.size() == 1) {
        glDrawElements(mode, runs.counts.front(), GL_UNSIGNED_INT, runs.starts.front());
    } else {
        glMultiDrawElements(mode, runs.counts.data(), GL_UNSIGNED_INT, runs.starts.data(),
                            static_cast<GLsizei>(runs.counts.size()));
    }
}

}  // namespace

DrawPieces::DrawPieces(std::span<const IndexRun> runs, const IndexRun& range, DrawOrder order)
    : m_runs(runs) {
    const std::uint32_t size = range.end - range.first;
    const std::uint32_t strands = order == DrawOrder::Any && size > kMost ? kStrands : 1;
    const std::uint32_t each = (size / strands + kWhole - 1) / kWhole * kWhole;
    for (std::uint32_t first = range.first; first < range.end; first += std::min(each, range.end - first)) {
        const std::uint32_t end = first + std::min(each, range.end - first);
        const auto isBefore = [first](const IndexRun& run) { return run.end <= first; };
        m_strands.push_back({std::partition_point(runs.begin(), runs.end(), isBefore), first, end});
    }
}

IndexRuns DrawPieces::next() {
    IndexRuns piece;
    while (piece.indices == 0 && !m_strands.empty()) {
        const auto share = static_cast<std::uint32_t>(kMost / m_strands.size() / kWhole * kWhole);
        for (Strand& strand : m_strands) {
            take(strand, share, piece);
        }
        std::erase_if(m_strands, [](const Strand& strand) { return strand.next == strand.end; });
    }
    return piece;
}

void DrawPieces::take(Strand& strand, std::uint32_t most, IndexRuns& piece) const {
    while (most > 0 && strand.next < strand.end) {
        if (strand.run == m_runs.end() || strand.run->first >= strand.end) {
            strand.next = strand.end;
            return;
        }
        strand.next = std::max(strand.next, strand.run->first);
        const std::uint32_t count = std::min({strand.run->end - strand.next, strand.end - strand.next, most});
        if (count > 0) {
            piece.add(strand.next, count);
        }
        strand.next += count;
        most -= count;
        if (strand.next == strand.run->end) {
            ++strand.run;
        }
    }
}

std::size_t drawRuns(GLenum mode, std::span<const IndexRun> runs) {
    IndexRuns all;
    for (const IndexRun& run : runs) {
        all.add(run.first, run.end - run.first);
    }
    if (all.indices > 0) {
        draw(mode, all);
    }
    return all.indices;
}

std::size_t drawBounded(const FrameContext& context, GLenum mode, std::span<const IndexRun> runs,
                        const IndexRun& range, DrawOrder order) {
    if (!context.software) {
        return drawRuns(mode, within(runs, range));
    }
    const bool isOne = std::min<std::size_t>(countOf(runs), range.end - range.first) <= DrawPieces::kMost;
    WaitForLastButOne wait;
    DrawPieces pieces(runs, range, order);
    std::size_t drawn = 0;
    for (IndexRuns piece = pieces.next(); piece.indices > 0; piece = pieces.next()) {
        draw(mode, piece);
        drawn += piece.indices;
        if (!isOne) {
            wait.drawn();
        }
    }
    return drawn;
}

std::size_t drawBounded(const FrameContext& context, GLenum mode, const IndexRun& range, DrawOrder order) {
    return drawBounded(context, mode, std::span(&range, 1), range, order);
}

}  // namespace hitscope::render
