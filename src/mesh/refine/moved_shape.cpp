// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/refine/moved_shape.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "mesh/same_bits.h"

namespace hitscope {

MeshData withShape(MeshData mesh, std::span<const glm::vec3> positions) {
    std::vector<bool> moves(mesh.vertexCount(), false);
    for (std::size_t v = 0; v < moves.size(); ++v) {
        if (sameBits(mesh.positions[v], positions[v])) {
            continue;
        }
        moves[v] = true;
        mesh.positions[v] = positions[v];
        if (!mesh.filePositions.empty()) {
            mesh.filePositions[v] = mesh.placement.toFile(positions[v]);
        }
    }
    for (std::size_t f = 0; !mesh.cornerNormals.empty() && f < mesh.faceCount(); ++f) {
        const std::span<const std::uint32_t> face = mesh.face(f);
        if (std::any_of(face.begin(), face.end(), [&moves](std::uint32_t v) { return moves[v]; })) {
            std::fill(mesh.cornerNormals.begin() + mesh.faceStarts[f],
                      mesh.cornerNormals.begin() + mesh.faceStarts[f + 1], kNoIndex);
        }
    }
    if (mesh.sourceVertices.empty()) {
        mesh.sourceVertices.resize(mesh.vertexCount());
        std::iota(mesh.sourceVertices.begin(), mesh.sourceVertices.end(), 0U);
    }
    mesh.sourceHash = 0;
    return mesh;
}

}  // namespace hitscope
