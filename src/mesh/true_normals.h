// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "mesh/mesh_data.h"
#include "mesh/render_mesh.h"
#include "mesh/turned_normals.h"

namespace hitscope {

/// Shading normals that follow the dented surface. The paper's formula (eq. 2) leaves the normal of a head-on
/// hit as it was, so its dent would show no shading; here a vertex's original normal is turned by the
/// rotation that takes the area-weighted normal of its faces from the original to the current surface. Hard
/// edges stay hard: only faces that meet at the same original normal are averaged. Where nothing moved the
/// normals are the file's, bit for bit.
class TrueNormals {
public:
    /// What belongs together; both stay as they are.
    TrueNormals(std::shared_ptr<const MeshData> mesh, std::shared_ptr<const RenderMesh> render);
    /// The same of copies.
    TrueNormals(const MeshData& mesh, const RenderMesh& render);

    /// Recomputes around the given file vertices (any order, repeats allowed), at the current `positions`
    /// (one for each file vertex). Appends to `updated` the render vertices whose normal may have changed.
    /// Cost follows the input.
    void update(std::span<const glm::vec3> positions, std::span<const std::uint32_t> movedFileVertices,
                std::vector<std::uint32_t>& updated);
    void reset();

    /// Nothing was ever recomputed: normals() are the render mesh's.
    [[nodiscard]] bool areOriginal() const { return !m_wasUpdated; }
    /// One unit normal a render vertex. A copy keeps them as they are now, for another thread.
    [[nodiscard]] const TurnedNormals& normals() const { return m_normals; }

private:
    struct Groups;
    void recompute(std::uint32_t group, std::span<const glm::vec3> positions);
    void recompute(std::span<const std::uint32_t> groups, std::span<const glm::vec3> positions);

    std::shared_ptr<const Groups> m_groups;  ///< shared by the copies, as the mesh's size in memory counts
    TurnedNormals m_normals;
    bool m_wasUpdated = false;
    // Of the update() that runs.
    std::vector<std::uint32_t> m_concerned;  ///< groups
    std::vector<bool> m_isConcerned;         ///< group is one of them
};

}  // namespace hitscope
