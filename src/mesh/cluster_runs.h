// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mesh_data.h"

namespace hitscope {

struct DynamicVertex;

/// A run of triangles or edges drawn with one material: [first, first + count) entries of the index array.
struct DrawRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::uint32_t material = kNoIndex;
};

/// The triangles or edges of a render mesh by cluster: each belongs to that of its lowest vertex. Where all
/// of a run is drawn is told by the boxes of its cluster and of those that its other corners are in.
class ClusterRuns {
public:
    /// Of what is drawn with one material, neighbours of one cluster.
    struct Run {
        std::uint32_t first = 0;  ///< entry of the index array
        std::uint32_t end = 0;
        std::uint32_t cluster = 0;
        std::uint32_t othersStart = 0;  ///< others() has them
        Bounds bounds;                  ///< of the original positions
    };
    ClusterRuns() = default;
    /// indices: of `vertices`, `corners` an element (2 or 3), elements of each draw by their lowest one.
    /// draws: cover indices in order; none: all are one.
    /// before: entries of the index array that come before these.
    ClusterRuns(std::span<const DynamicVertex> vertices, std::span<const std::uint32_t> indices,
                std::size_t corners, std::span<const DrawRange> draws, std::size_t before = 0);

    /// In the order of the indices, which they cover.
    [[nodiscard]] std::span<const Run> runs() const { return m_runs; }
    /// The other clusters that elements of the run have corners in, each once.
    [[nodiscard]] std::span<const std::uint32_t> others(std::size_t run) const {
        const std::size_t end = run + 1 < m_runs.size() ? m_runs[run + 1].othersStart : m_others.size();
        return std::span(m_others).first(end).subspan(m_runs[run].othersStart);
    }

private:
    std::vector<Run> m_runs;
    std::vector<std::uint32_t> m_others;
};

}  // namespace hitscope
