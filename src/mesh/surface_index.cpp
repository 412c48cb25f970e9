// SPDX-License-Identifier: GPL-3.0-or-later
#include <numeric>

#include "mesh/surface_topology.h"

namespace hitscope {

SurfaceIndex::SurfaceIndex(const MeshData& mesh, const SurfaceTopology& topology) {
    m_faceStarts.assign(mesh.vertexCount() + 1, 0);
    for (const std::uint32_t vertex : mesh.cornerVertices) {
        ++m_faceStarts[vertex + 1];
    }
    std::partial_sum(m_faceStarts.begin(), m_faceStarts.end(), m_faceStarts.begin());
    m_faces.resize(mesh.cornerVertices.size());
    std::vector<std::uint32_t> next(m_faceStarts.begin(), m_faceStarts.end() - 1);
    for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) {
        for (const std::uint32_t vertex : mesh.face(f)) {
            m_faces[next[vertex]++] = f;
        }
    }
    const std::span<const SurfaceTopology::Edge> edges = topology.edges();
    m_edgeStarts.assign(mesh.vertexCount() + 1, 0);
    for (const SurfaceTopology::Edge& edge : edges) {
        ++m_edgeStarts[edge.low + 1];
        ++m_edgeStarts[edge.high + 1];
    }
    std::partial_sum(m_edgeStarts.begin(), m_edgeStarts.end(), m_edgeStarts.begin());
    m_vertexEdges.resize(2 * edges.size());
    next.assign(m_edgeStarts.begin(), m_edgeStarts.end() - 1);
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
        m_vertexEdges[next[edges[e].low]++] = e;
        m_vertexEdges[next[edges[e].high]++] = e;
    }
}

}  // namespace hitscope
