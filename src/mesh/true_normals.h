// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "mesh/mesh_data.h"
#include "mesh/render_mesh.h"

namespace hitscope {

/// Shading normals that follow the dented surface. The paper's formula (eq. 2) leaves the normal of a head-on
/// hit as it was, so its dent would show no shading; here a vertex's original normal is turned by the
/// rotation that takes the area-weighted normal of its faces from the original to the current surface. Hard
/// edges stay hard: only faces that meet at the same original normal are averaged. Where nothing moved the
/// normals are the file's, bit for bit.
class TrueNormals {
public:
    TrueNormals(const MeshData& mesh, const RenderMesh& render);

    /// Recomputes around the given file vertices (any order, repeats allowed), at the current `positions`
    /// (one for each file vertex). Appends to `updated` the render vertices whose normal may have changed.
    /// Cost follows the input.
    void update(std::span<const glm::vec3> positions, std::span<const std::uint32_t> movedFileVertices,
                std::vector<std::uint32_t>& updated);
    void reset();

    /// One unit normal a render vertex.
    [[nodiscard]] std::span<const glm::vec3> normals() const { return m_normals; }

private:
    // A group is what shares one normal: a file vertex and the faces that meet there at the same original
    // normal (and so the render vertices that differ in texture coordinates only). Groups are numbered vertex
    // by vertex.
    void groupRenderVertices(const RenderMesh& render);
    void groupFaces(const RenderMesh& render);
    [[nodiscard]] glm::dvec3 areaOf(std::uint32_t group, std::span<const glm::vec3> positions) const;
    void recompute(std::uint32_t group, std::span<const glm::vec3> positions);
    void recompute(std::span<const std::uint32_t> groups, std::span<const glm::vec3> positions);

    std::vector<glm::vec3> m_normals;
    std::vector<glm::vec3> m_originals;           ///< one a render vertex
    std::vector<std::uint32_t> m_faceStarts;      ///< as in MeshData
    std::vector<std::uint32_t> m_cornerVertices;  ///< as in MeshData
    std::vector<std::uint32_t> m_cornerGroups;    ///< one a corner
    std::vector<std::uint32_t> m_vertexStarts;    ///< file vertex -> first of its groups; V + 1 entries
    std::vector<std::uint32_t> m_renderStarts;    ///< group -> its run of m_renderVertices
    std::vector<std::uint32_t> m_renderVertices;
    std::vector<std::uint32_t> m_groupFaceStarts;  ///< group -> its run of m_groupFaces
    std::vector<std::uint32_t> m_groupFaces;
    std::vector<glm::dvec3> m_originalAreas;  ///< group -> sum of its faces' area vectors, undented
    std::vector<std::uint32_t> m_visited;     ///< group -> the update() that recomputed it last
    std::uint32_t m_pass = 0;
    std::vector<std::uint32_t> m_concerned;  ///< groups, of the update() that runs
};

}  // namespace hitscope
