// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "deform/hit.h"
#include "deform/vertex_range.h"
#include "mesh/render_mesh.h"

namespace hitscope {

/// What a hit would do to a target as it is now, by the reference deformation.
struct DentPreview {
    std::size_t affectedVertices = 0;  ///< of the file, that would move
    float depth = 0.0f;                ///< metres: the farthest that one of them would move
    /// Three corners a triangle, metres, local frame: of those of `triangles` with a corner that would move,
    /// where they would be.
    std::vector<glm::vec3> dent;
};

/// `current`: the target's render vertices, one for each of the mesh's. `reach`: ranges of them outside of
/// which none is within reachOf(hit). `triangles`: indices of those to show. Costs
/// by the reach and the triangles given.
[[nodiscard]] DentPreview previewDent(const RenderMesh& mesh, std::span<const DynamicVertex> current,
                                      std::span<const VertexRange> reach,
                                      std::span<const std::uint32_t> triangles, const Hit& hit);

/// The clusters whose vertices' boxes come within `distance` metres of `point`, as ranges of vertices, sorted
/// and merged. `boxes`: one a cluster of the mesh, as its vertices are now.
[[nodiscard]] std::vector<VertexRange> clustersNear(const RenderMesh& mesh, std::span<const Bounds> boxes,
                                                    const glm::vec3& point, float distance);

}  // namespace hitscope
