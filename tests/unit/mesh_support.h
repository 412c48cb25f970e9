// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <vector>

#include "mesh/mesh_data.h"

namespace hitscope::test {

/// A mesh of positions and polygons, nothing else.
inline MeshData meshOf(PageVector<glm::vec3> positions,
                       const std::vector<std::vector<std::uint32_t>>& faces) {
    MeshData mesh;
    mesh.positions = std::move(positions);
    mesh.faceStarts.push_back(0);
    for (const std::vector<std::uint32_t>& face : faces) {
        mesh.cornerVertices.insert(mesh.cornerVertices.end(), face.begin(), face.end());
        mesh.faceStarts.push_back(static_cast<std::uint32_t>(mesh.cornerVertices.size()));
    }
    return mesh;
}

/// The same faces and positions without the normals that came with them.
inline MeshData withoutNormals(MeshData mesh) {
    mesh.normals.clear();
    mesh.cornerNormals.clear();
    return mesh;
}

/// One flat polygon in the plane z = 0.
inline MeshData polygon(const std::vector<glm::vec2>& outline) {
    PageVector<glm::vec3> positions;
    std::vector<std::uint32_t> face;
    for (const glm::vec2& point : outline) {
        face.push_back(static_cast<std::uint32_t>(positions.size()));
        positions.emplace_back(point, 0.0f);
    }
    return meshOf(std::move(positions), {face});
}

}  // namespace hitscope::test
