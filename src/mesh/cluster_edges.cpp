// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cluster_edges.h"

namespace hitscope {

ClusterEdges::ClusterEdges(const RenderMesh& mesh) {
    const auto edges = static_cast<std::uint32_t>(mesh.edges.size() / 2);
    std::vector<std::uint32_t> knownTo(mesh.clusters.size(), kNoIndex);  // the last cluster to end there
    m_firsts.reserve(mesh.clusters.size() + 1);
    m_endStarts.reserve(mesh.clusters.size() + 1);
    std::uint32_t edge = 0;
    for (std::uint32_t cluster = 0; cluster < mesh.clusters.size(); ++cluster) {
        m_firsts.push_back(edge);
        m_endStarts.push_back(static_cast<std::uint32_t>(m_ends.size()));
        // Edges come in the order of their first, lower ends; all clusters but the last are full.
        const std::uint32_t end = mesh.clusters[cluster].first + mesh.clusters[cluster].count;
        for (; edge < edges && mesh.edges[2 * std::size_t{edge}] < end; ++edge) {
            const std::uint32_t other = mesh.edges[2 * std::size_t{edge} + 1] / kClusterVertices;
            if (other != cluster && knownTo[other] != cluster) {
                knownTo[other] = cluster;
                m_ends.push_back(other);
            }
        }
    }
    m_firsts.push_back(edge);
    m_endStarts.push_back(static_cast<std::uint32_t>(m_ends.size()));
}

}  // namespace hitscope
