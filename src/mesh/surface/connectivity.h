// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "mesh/mesh_data.h"
#include "mesh/surface/surface_topology.h"

namespace hitscope {

/// What OpenMesh's half-edges tell about the faces that they can hold.
struct Connectivity {
    std::size_t vertices = 0;  ///< used by an accepted face
    std::size_t edges = 0;
    std::size_t faces = 0;  ///< accepted
    std::size_t boundaryEdges = 0;
    std::size_t components = 0;  ///< of the accepted faces, connected through edges
    std::size_t refused = 0;     ///< faces without a repeated vertex that cannot be connected
};

/// Connects mesh's faces in their order, leaving out those that repeat a vertex. `edges`: about how many
/// there are, if that is known, so that room for them is made once.
[[nodiscard]] Connectivity connect(const MeshData& mesh, std::size_t edges = 0);

/// connect(mesh).refused. Half-edges take some hundred bytes a vertex: they are made only where `topology`,
/// of this mesh, leaves open whether they can hold all faces.
[[nodiscard]] std::size_t refusedFaces(const MeshData& mesh, const SurfaceTopology& topology);

/// Whether a face names a vertex twice.
[[nodiscard]] bool repeatsVertex(std::span<const std::uint32_t> face);

}  // namespace hitscope
