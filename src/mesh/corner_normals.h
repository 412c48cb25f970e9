// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "mesh/mesh_data.h"

namespace hitscope {

/// Radians between faces from which computed normals keep them apart, where nothing else is said.
inline constexpr float kCreaseAngle = 0.7853982f;

/// The corners of every vertex: those of v are corners[starts[v]] .. corners[starts[v + 1]], ascending.
struct VertexCorners {
    explicit VertexCorners(const MeshData& mesh);
    [[nodiscard]] std::span<const std::uint32_t> of(std::size_t vertex) const {
        return std::span(corners).subspan(starts[vertex], starts[vertex + 1] - starts[vertex]);
    }

    std::vector<std::uint32_t> starts;   ///< V + 1 entries
    std::vector<std::uint32_t> corners;  ///< C entries
};

/// One unit normal a corner: the file's where it has a usable one, else computed from the faces around the
/// vertex (buildRenderMesh says how).
class CornerNormals {
public:
    /// `mesh` outlives this.
    CornerNormals(const MeshData& mesh, const VertexCorners& vertexCorners, float creaseAngle);

    [[nodiscard]] const glm::vec3& operator[](std::size_t corner) const {
        return m_ofCorners.empty() ? m_units[m_mesh.cornerNormals[corner]] : m_ofCorners[corner];
    }

private:
    [[nodiscard]] bool isComplete() const;

    const MeshData& m_mesh;
    std::vector<glm::vec3> m_units;      ///< of the file's normals; zero: not usable
    std::vector<glm::vec3> m_ofCorners;  ///< empty: the file's do for all corners
};

/// The same as a list: one a corner.
[[nodiscard]] std::vector<glm::vec3> cornerNormals(const MeshData& mesh, float creaseAngle);

}  // namespace hitscope
