// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "core/bounds.h"
#include "mesh/mesh_data.h"

namespace hitscope {

/// What the mesh statistics show. Topology is that of the original; a hit never changes it.
struct TopologyStatistics {
    std::size_t vertices = 0;
    std::size_t unreferencedVertices = 0;
    std::size_t edges = 0;  ///< of all faces, each once, as the wireframe draws them
    std::size_t faces = 0;
    std::size_t triangles = 0;       ///< faces with 3 corners
    std::size_t quads = 0;           ///< faces with 4 corners
    std::size_t largerPolygons = 0;  ///< faces with 5 or more corners
    std::size_t boundaryEdges = 0;
    std::size_t components = 0;       ///< faces OpenMesh accepted, connected where they share an edge
    std::size_t degenerateFaces = 0;  ///< faces that repeat a vertex; sorted out before OpenMesh sees them
    /// Faces that OpenMesh cannot connect: complex edges or vertices, or (so that no file takes minutes) one
    /// of tens of thousands of faces that share a vertex in no order.
    std::size_t nonManifoldFaces = 0;
    /// V - E + F of the accepted faces; nothing where faces were left out.
    std::optional<long long> eulerCharacteristic;
    bool watertight = false;  ///< no boundary, nothing left out
};

struct GeometryStatistics {
    Bounds bounds;                 ///< metres, local frame
    double surfaceArea = 0.0;      ///< square metres
    std::optional<double> volume;  ///< cubic metres, >= 0 whichever way the faces look; only if watertight
};

[[nodiscard]] TopologyStatistics computeTopology(const MeshData& mesh);

/// Of the mesh's faces at `positions` (one for each of mesh.positions). Polygons are measured as fans about
/// their first corner; what a concave polygon's fan covers twice counts against itself.
[[nodiscard]] GeometryStatistics computeGeometry(const MeshData& mesh, std::span<const glm::vec3> positions,
                                                 const TopologyStatistics& topology);

}  // namespace hitscope
