// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/connectivity.h"

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <algorithm>
#include <vector>

#include "mesh/refine/face_gate.h"

namespace hitscope {
namespace {

using HalfEdges = OpenMesh::PolyConnectivity;
using Vertices = std::vector<OpenMesh::VertexHandle>;

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

/// Where all faces around each vertex are one fan and look the same way, a face always finds its sides free
/// and a gap at its corners, in whatever order they come: it never closes a fan before the last one, and two
/// parts of a fan that it joins were next to each other. FaceGate gives up on vertices of many faces alone.
std::size_t refusedFaces(const MeshData& mesh, const SurfaceTopology& topology) {
    const SurfaceStatistics& surface = topology.statistics();
    bool isHeld = surface.isManifold() && surface.opposedEdges == 0 && surface.collapsedFaces == 0;
    std::vector<std::uint8_t> faces(isHeld ? mesh.vertexCount() : 0, 0);
    for (std::size_t c = 0; c < mesh.cornerVertices.size() && isHeld; ++c) {
        isHeld = ++faces[mesh.cornerVertices[c]] < FaceGate::kMostSteps;
    }
    return isHeld ? 0 : connect(mesh, surface.edges).refused;
}

Connectivity connect(const MeshData& mesh, std::size_t edges) {
    HalfEdges halfEdges;
    halfEdges.reserve(mesh.vertexCount(), std::max(edges, mesh.cornerVertices.size() / 2), mesh.faceCount());
    for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
        halfEdges.add_vertex();
    }
    // What the gate cannot foresee (faces around a vertex that no order joins) OpenMesh refuses
    // itself, with a line on this stream that nobody asked for.
    omerr().disable();
    Connectivity result;
    FaceGate gate(halfEdges);
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
