// SPDX-License-Identifier: GPL-3.0-or-later
// For the sources of this folder that use OpenMesh.
#pragma once

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <cstdint>
#include <vector>

namespace hitscope {

/// Decides whether OpenMesh can take a face. It is asked before: OpenMesh reports some of these on the error
/// stream, and stops the program on others.
class FaceGate {
public:
    static constexpr int kMostSteps = 64;  ///< round a vertex, once few are left

    explicit FaceGate(const OpenMesh::PolyConnectivity& halfEdges) : m_halfEdges(halfEdges) {}

    /// Faces that name a vertex twice are not asked about.
    [[nodiscard]] bool admits(const std::vector<OpenMesh::VertexHandle>& face) {
        for (std::size_t i = 0; i < face.size(); ++i) {
            // A vertex with faces all around it has no gap for another; an edge with a face on this side
            // already has no room for a third face, or for one that is turned over.
            if (!m_halfEdges.is_boundary(face[i]) || !isSideFree(face[i], face[(i + 1) % face.size()])) {
                return false;
            }
        }
        return true;
    }

private:
    /// Finding an edge means going round the vertex. Where faces in no order share a hub, that takes time in
    /// proportion to the square of their number (100,000: minutes), so the steps are limited; once they are
    /// used up, only small vertices are gone round.
    [[nodiscard]] bool isSideFree(OpenMesh::VertexHandle from, OpenMesh::VertexHandle to) {
        int steps = 0;
        for (const OpenMesh::HalfedgeHandle side : m_halfEdges.voh_range(from)) {
            if (m_halfEdges.to_vertex_handle(side) == to) {
                return m_halfEdges.is_boundary(side);
            }
            m_stepsLeft -= m_stepsLeft > 0 ? 1 : 0;
            if (m_stepsLeft == 0 && ++steps > kMostSteps) {
                return false;
            }
        }
        return true;
    }

    const OpenMesh::PolyConnectivity& m_halfEdges;
    std::uint64_t m_stepsLeft = 100'000'000;
};

}  // namespace hitscope
