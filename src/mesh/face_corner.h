// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "mesh/mesh_data.h"

namespace hitscope {

/// A corner of a face: indices into MeshData's arrays, kNoIndex where it has none.
struct FaceCorner {
    std::uint32_t vertex = 0;
    std::uint32_t texcoord = kNoIndex;
    std::uint32_t normal = kNoIndex;
};

/// Appends a face to a mesh whose corners all have entries for texture coordinates and normals.
inline void addFace(MeshData& mesh, std::span<const FaceCorner> corners) {
    for (const FaceCorner& corner : corners) {
        mesh.cornerVertices.push_back(corner.vertex);
        mesh.cornerTexcoords.push_back(corner.texcoord);
        mesh.cornerNormals.push_back(corner.normal);
    }
    mesh.faceStarts.push_back(static_cast<std::uint32_t>(mesh.cornerVertices.size()));
}

}  // namespace hitscope
