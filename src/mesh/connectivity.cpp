// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/connectivity.h"

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <algorithm>
#include <vector>

namespace hitscope {
namespace {

using HalfEdges = OpenMesh::PolyConnectivity;
using Vertices = std::vector<OpenMesh::VertexHandle>;

/// Decides whether OpenMesh can take a face. It is asked before: OpenMesh reports some of these on the error
/// stream, and stops the program on others.
class Gate {
public:
    explicit Gate(const HalfEdges& halfEdges) : m_halfEdges(halfEdges) {}

    [[nodiscard]] bool admits(const Vertices& face) {
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
            if (m_stepsLeft == 0 && ++steps > 64) {
                return false;
            }
        }
        return true;
    }

    const HalfEdges& m_halfEdges;
    std::uint64_t m_stepsLeft = 100'000'000;
};

std::size_t countComponents(const HalfEdges& halfEdges) {
    std::vector<bool> seen(halfEdges.n_faces(), false);
    std::vector<OpenMesh::FaceHandle> open;
    std::size_t components = 0;
    for (const OpenMesh::FaceHandle start : halfEdges.faces()) {
        if (seen[static_cast<std::size_t>(start.idx())]) {
            continue;
        }
        ++components;
        seen[static_cast<std::size_t>(start.idx())] = true;
        open.push_back(start);
        while (!open.empty()) {
            const OpenMesh::FaceHandle face = open.back();
            open.pop_back();
            for (const OpenMesh::FaceHandle neighbour : halfEdges.ff_range(face)) {
                const auto index = static_cast<std::size_t>(neighbour.idx());
                if (!seen[index]) {
                    seen[index] = true;
                    open.push_back(neighbour);
                }
            }
        }
    }
    return components;
}

}  // namespace

bool repeatsVertex(std::span<const std::uint32_t> face) {
    if (face.size() == 3) {
        return face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
    }
    std::vector<std::uint32_t> sorted(face.begin(), face.end());
    std::sort(sorted.begin(), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

Connectivity connect(const MeshData& mesh) {
    HalfEdges halfEdges;
    halfEdges.reserve(mesh.vertexCount(), mesh.cornerVertices.size() / 2, mesh.faceCount());
    for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
        halfEdges.add_vertex();
    }
    // What the gate cannot foresee (faces around a vertex that no order joins) OpenMesh refuses
    // itself, with a line on this stream that nobody asked for.
    omerr().disable();
    Connectivity result;
    Gate gate(halfEdges);
    Vertices face;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        if (repeatsVertex(mesh.face(f))) {
            continue;
        }
        face.clear();
        for (const std::uint32_t vertex : mesh.face(f)) {
            face.emplace_back(static_cast<int>(vertex));
        }
        if (!gate.admits(face) || !halfEdges.add_face(face).is_valid()) {
            ++result.refused;
        }
    }
    result.edges = halfEdges.n_edges();
    result.faces = halfEdges.n_faces();
    for (const OpenMesh::VertexHandle vertex : halfEdges.vertices()) {
        result.vertices += halfEdges.is_isolated(vertex) ? 0 : 1;
    }
    for (const OpenMesh::EdgeHandle edge : halfEdges.edges()) {
        result.boundaryEdges += halfEdges.is_boundary(edge) ? 1 : 0;
    }
    result.components = countComponents(halfEdges);
    return result;
}

}  // namespace hitscope
