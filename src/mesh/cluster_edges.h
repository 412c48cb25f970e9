// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/render_mesh.h"

namespace hitscope {

/// The edges of a render mesh by cluster: each belongs to that of its first end. Where all of a cluster's
/// edges are is told by the boxes of that cluster and of those its edges end in.
class ClusterEdges {
public:
    explicit ClusterEdges(const RenderMesh& mesh);

    /// Edges [first, end) of the mesh.
    struct Run {
        std::uint32_t first = 0;
        std::uint32_t end = 0;
    };
    [[nodiscard]] Run of(std::size_t cluster) const { return {m_firsts[cluster], m_firsts[cluster + 1]}; }
    /// The other clusters in which they end, each once.
    [[nodiscard]] std::span<const std::uint32_t> endsOf(std::size_t cluster) const {
        return std::span(m_ends).subspan(m_endStarts[cluster],
                                         m_endStarts[cluster + 1] - m_endStarts[cluster]);
    }

private:
    std::vector<std::uint32_t> m_firsts;     // one a cluster, and the end of the last
    std::vector<std::uint32_t> m_endStarts;  // likewise
    std::vector<std::uint32_t> m_ends;
};

}  // namespace hitscope
