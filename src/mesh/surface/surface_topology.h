// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "mesh/mesh_data.h"

namespace hitscope {

/// What holds of a surface however its vertices are moved. Vertices that faces use and that are at the very
/// same place count as one: files split them along seams of texture and normals, and hits, which go by the
/// place, never part them.
struct SurfaceStatistics {
    std::size_t vertices = 0;              ///< as the file has them
    std::size_t unreferencedVertices = 0;  ///< no face uses them
    std::size_t places = 0;                ///< different places of the vertices that faces use
    std::size_t edges = 0;                 ///< each once, however many faces share it
    std::size_t faces = 0;                 ///< as the file has them
    std::size_t triangles = 0;             ///< faces with 3 corners
    std::size_t quads = 0;                 ///< faces with 4 corners
    std::size_t largerPolygons = 0;        ///< faces with 5 or more corners
    std::size_t collapsedFaces = 0;        ///< fewer than 3 corners apart, or turning back at one: in no edge
    std::size_t boundaryEdges = 0;         ///< with one face
    std::size_t holes = 0;                 ///< closed lines of boundary edges
    std::size_t components = 0;            ///< of faces, joined where they share an edge
    std::size_t nonManifoldEdges = 0;      ///< with three faces or more
    /// Where fans of faces meet that share no edge there; ends of non-manifold edges are not counted again.
    std::size_t nonManifoldVertices = 0;
    /// Edges whose two faces run along them the same way, so that one of the two is turned over.
    std::size_t opposedEdges = 0;
    bool orientable = true;             ///< the faces can be turned so that there are no such edges
    long long eulerCharacteristic = 0;  ///< places - edges + faces, collapsed ones and theirs left out
    std::optional<long long> genus;     ///< handles, all components together; only if manifold and orientable
    bool watertight = false;            ///< manifold, without boundary, with at least one face
    bool operator==(const SurfaceStatistics&) const = default;

    /// Counts in another surface, apart from this one.
    void add(const SurfaceStatistics& other);
    [[nodiscard]] bool isManifold() const { return nonManifoldEdges == 0 && nonManifoldVertices == 0; }
    /// Encloses a volume whose sign is the same everywhere.
    [[nodiscard]] bool isSolid() const { return watertight && opposedEdges == 0; }
};

/// How the faces of a mesh hang together. Immutable; may be read on any thread.
class SurfaceTopology {
public:
    /// An edge's two file vertices, the lower first; of vertices at one place, the one of lowest number.
    struct Edge {
        std::uint32_t low = 0;
        std::uint32_t high = 0;
        bool operator==(const Edge&) const = default;
    };

    /// `mesh` has passed validate(). Takes time in proportion to the mesh (about a second for a million
    /// vertices): for another thread. Null once `stop` is requested.
    [[nodiscard]] static std::shared_ptr<const SurfaceTopology> build(const MeshData& mesh,
                                                                      const std::stop_token& stop = {});

    [[nodiscard]] const SurfaceStatistics& statistics() const { return m_statistics; }
    [[nodiscard]] std::span<const Edge> edges() const { return m_edges; }

private:
    friend class SurfaceTopologyBuilder;
    SurfaceTopology() = default;

    SurfaceStatistics m_statistics;
    std::vector<Edge> m_edges;  ///< sorted
};

}  // namespace hitscope
