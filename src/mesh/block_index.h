// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hitscope {

/// In which blocks of a list (of faces, of edges) the vertices of a mesh are named. Vertices are looked up by
/// runs, so that a large mesh takes about half a byte a vertex where neighbours have neighbouring numbers,
/// and less than four bytes for each time that a vertex is named where they have not.
class BlockIndex {
public:
    static constexpr std::size_t kBlock = 256;  ///< entries of the list
    static constexpr std::uint32_t kRunVertices = 16;

    BlockIndex() = default;
    /// `verticesOf(entry)` gives a range of the vertices of entry 0 <= entry < entries, each < vertices.
    template <class VerticesOf>
    BlockIndex(std::size_t vertices, std::size_t entries, const VerticesOf& verticesOf);

    /// Blocks that name a vertex of the run, ascending.
    [[nodiscard]] std::span<const std::uint32_t> blocksOfRun(std::uint32_t run) const {
        return std::span(m_blocks).subspan(m_starts[run], m_starts[run + 1] - m_starts[run]);
    }
    [[nodiscard]] static std::uint32_t runOf(std::uint32_t vertex) { return vertex / kRunVertices; }
    [[nodiscard]] static std::size_t blocksOf(std::size_t entries) { return (entries + kBlock - 1) / kBlock; }

private:
    std::vector<std::uint32_t> m_starts;  ///< run -> its first of m_blocks; and one more
    std::vector<std::uint32_t> m_blocks;
};

template <class VerticesOf>
BlockIndex::BlockIndex(std::size_t vertices, std::size_t entries, const VerticesOf& verticesOf) {
    constexpr std::uint32_t kNone = 0xffffffffu;
    const std::size_t runs = (vertices + kRunVertices - 1) / kRunVertices;
    std::vector<std::uint32_t> last;  // block that a run was found in
    const auto forEachFound = [&](const auto& found) {
        last.assign(runs, kNone);
        for (std::size_t entry = 0; entry < entries; ++entry) {
            const auto block = static_cast<std::uint32_t>(entry / kBlock);
            for (const std::uint32_t vertex : verticesOf(entry)) {
                if (const std::uint32_t run = runOf(vertex); last[run] != block) {
                    last[run] = block;  // blocks ascend: it is not found in an earlier one again
                    found(run, block);
                }
            }
        }
    };
    m_starts.assign(runs + 1, 0);
    forEachFound([this](std::uint32_t run, std::uint32_t) { ++m_starts[run + 1]; });
    for (std::size_t run = 0; run < runs; ++run) {
        m_starts[run + 1] += m_starts[run];
    }
    m_blocks.resize(m_starts.back());
    std::vector<std::uint32_t> next(m_starts.begin(), m_starts.end() - 1);
    forEachFound([&](std::uint32_t run, std::uint32_t block) { m_blocks[next[run]++] = block; });
}

}  // namespace hitscope
