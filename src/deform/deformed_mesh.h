// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "core/page_vector.h"
#include "deform/cluster_reach.h"
#include "mesh/mesh_data.h"
#include "mesh/render_mesh.h"

namespace hitscope {

/// What the changed vertices of a target amount to. Lengths in metres.
struct DisplacementStatistics {
    std::size_t changedVertices = 0;  ///< file vertices whose displacement is not zero
    double maximum = 0.0;             ///< largest displacement
    double mean = 0.0;                ///< over the changed vertices
    double rms = 0.0;                 ///< over the changed vertices
};

/// The CPU's copy of one target's current vertices, as the active pipeline made them.
///
/// Ownership protocol: the pipeline's buffers are the truth; this copy is current for exactly the ranges that
/// write() brought. Who applies hits reads the changed ranges back and writes them here; everyone else only
/// reads.
class DeformedMesh {
public:
    DeformedMesh(std::shared_ptr<const MeshData> original, std::shared_ptr<const RenderMesh> render);

    /// Takes over vertices [first, first + vertices.size()) as read back. Cost follows the range. File
    /// vertices that are now somewhere else are appended to `moved`; some may be repeated.
    void write(std::uint32_t first, std::span<const DynamicVertex> vertices,
               std::vector<std::uint32_t>& moved);
    /// Back to the original.
    void reset();
    /// The same mesh with other materials or pictures: its vertices and faces are equal.
    void setMaterialsFrom(std::shared_ptr<const MeshData> original) { m_original = std::move(original); }

    /// Current render vertices; render().vertices.size() entries.
    [[nodiscard]] std::span<const DynamicVertex> vertices() const {
        return m_isOriginal ? std::span<const DynamicVertex>(m_render->vertices) : m_vertices.all();
    }
    /// Current positions in the file's own order; original().positions.size() entries.
    [[nodiscard]] std::span<const glm::vec3> positions() const {
        return m_isOriginal ? std::span<const glm::vec3>(m_original->positions) : m_positions.all();
    }
    [[nodiscard]] bool isChanged(std::uint32_t fileVertex) const;
    [[nodiscard]] glm::vec3 displacement(std::uint32_t fileVertex) const;
    /// Every changed vertex, each once and in no order, and perhaps some that are back at their original.
    [[nodiscard]] std::span<const std::uint32_t> onceChanged() const { return m_changed; }
    /// Of all changed vertices; costs time in proportion to the vertices changed so far.
    [[nodiscard]] DisplacementStatistics statistics() const;
    /// Grows with every write() and reset().
    [[nodiscard]] std::uint64_t revision() const { return m_revision; }

    [[nodiscard]] const MeshData& original() const { return *m_original; }
    [[nodiscard]] const RenderMesh& render() const { return *m_render; }
    [[nodiscard]] std::shared_ptr<const MeshData> sharedOriginal() const { return m_original; }
    [[nodiscard]] std::shared_ptr<const RenderMesh> sharedRender() const { return m_render; }

private:
    void makeOwn();

    std::shared_ptr<const MeshData> m_original;
    std::shared_ptr<const RenderMesh> m_render;
    bool m_isOriginal =
        true;  ///< nothing was written yet: what follows is empty, as large meshes take memory
    PageCopy<DynamicVertex> m_vertices;
    PageCopy<glm::vec3> m_positions;
    std::vector<std::uint32_t> m_changed;  ///< file vertices that were ever changed, each once
    std::vector<bool> m_listed;            ///< file vertex is in m_changed
    std::uint64_t m_revision = 0;
};

}  // namespace hitscope
