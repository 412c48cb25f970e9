// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "core/bounds.h"
#include "core/raw_vector.h"
#include "mesh/cluster_runs.h"
#include "mesh/cluster_tree.h"
#include "mesh/corner_normals.h"
#include "mesh/mesh_data.h"

namespace hitscope {

/// A run of neighbouring render vertices, [first, first + count), and the box around them.
struct Cluster {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    Bounds bounds;  ///< of the original positions
};

/// Position and unit normal: the part of a vertex that hits change, laid out as in the GPU's buffer (24
/// bytes).
struct DynamicVertex {
    glm::vec3 position{0.0f};
    glm::vec3 normal{0.0f};
};
static_assert(sizeof(DynamicVertex) == 24);

/// What the GPU draws, made from MeshData: one render vertex for each different (vertex, normal, texture
/// coordinate) of the faces' corners, ordered so that neighbours in space are neighbours in the buffer. A
/// vertex that no face uses has one render vertex, behind all those: hits move it as any other, and no
/// triangle or edge draws it.
struct RenderMesh {
    PageVector<DynamicVertex> vertices;  ///< R entries, original state
    std::uint32_t drawnVertices =
        0;                           ///< so many of them, the first, are of faces; the others' normal is zero
    RawVector<glm::vec2> texcoords;  ///< R entries (zero where the file has none)
    RawVector<std::uint32_t> fileVertices;          ///< R entries: index into MeshData::positions
    RawVector<std::uint32_t> cornerRenderVertices;  ///< one a corner of MeshData: its render vertex
    /// 3 a triangle, render vertex indices, counter-clockwise as in the file; each draw's by their lowest
    /// one.
    RawVector<std::uint32_t> triangles;
    RawVector<std::uint32_t> triangleFaces;  ///< 1 a triangle: index of its face in MeshData
    /// 2 an edge, lower one first and in its order: each edge of the file's polygons once, between the first
    /// render vertices of its ends.
    RawVector<std::uint32_t> edges;
    std::vector<DrawRange> draws;  ///< cover `triangles`, one a material
    ClusterRuns triangleRuns;      ///< of `triangles`
    /// Of a large mesh, fewer triangles between the same vertices, for pictures that move: see
    /// coarse_triangles.h. Empty of others.
    std::vector<std::uint32_t> coarseTriangles;
    std::vector<DrawRange> coarseDraws;  ///< cover `coarseTriangles`, one a material
    ClusterRuns coarseRuns;              ///< of `coarseTriangles`, as if they came behind `triangles`
    std::vector<Cluster> clusters;       ///< cover `vertices`, in order; all but the last are full
    std::shared_ptr<const ClusterTree> clusterTree;  ///< of `clusters`
    Bounds bounds;                                   ///< of the original positions that faces use

    /// File vertex -> its render vertices: renderVerticesOf(v) lists them, one at least.
    std::vector<std::uint32_t> fileVertexStarts;  ///< V + 1 entries
    std::vector<std::uint32_t> fileVertexRender;  ///< R entries
    [[nodiscard]] std::span<const std::uint32_t> renderVerticesOf(std::uint32_t fileVertex) const {
        return std::span(fileVertexRender)
            .subspan(fileVertexStarts[fileVertex],
                     fileVertexStarts[fileVertex + 1] - fileVertexStarts[fileVertex]);
    }
};

/// Most vertices in a cluster. The paper's dent affects about 80 vertices of its finest sphere: with clusters
/// of this size a hit works on a few times as many, with larger ones on far more, and with smaller ones the
/// bookkeeping costs more than it saves.
inline constexpr std::uint32_t kClusterVertices = 64;

/// Builds the above. Corners without a normal get a computed one: area-weighted over the faces around the
/// vertex that meet within `creaseAngle` radians (or share the file's smoothing group, where it has them).
/// Polygons are triangulated (convex and concave, by ear clipping in their best plane). `mesh` has passed
/// validate().
[[nodiscard]] RenderMesh buildRenderMesh(const MeshData& mesh, float creaseAngle = kCreaseAngle);

}  // namespace hitscope
