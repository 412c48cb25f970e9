// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <span>
#include <vector>

#include "deform/vertex_range.h"
#include "mesh/render_mesh.h"

namespace hitscope {

/// A copy of a mesh's vertices that is made cluster by cluster, when one is first asked for. Its room is
/// asked of the system at once but not touched: a large mesh with a few dents takes memory for these.
class VertexCopy {
public:
    /// `mesh` outlives this.
    explicit VertexCopy(const RenderMesh& mesh);

    [[nodiscard]] std::span<DynamicVertex> cluster(std::uint32_t index);
    /// Back to the mesh's own.
    void restore(std::uint32_t cluster);
    [[nodiscard]] std::span<const DynamicVertex> range(const VertexRange& range);
    [[nodiscard]] std::span<const DynamicVertex> all() {
        return range({0, static_cast<std::uint32_t>(m_mesh->vertices.size())});
    }
    /// Clusters that were asked for, ascending.
    [[nodiscard]] std::vector<std::uint32_t> copied() const;

private:
    struct Free {
        void operator()(void* block) const { std::free(block); }
    };
    void copy(std::uint32_t cluster);

    const RenderMesh* m_mesh;
    std::unique_ptr<DynamicVertex, Free> m_vertices;  ///< as many as the mesh's
    std::vector<bool> m_isCopied;                     ///< by cluster
    std::size_t m_left;                               ///< clusters that are not
};

}  // namespace hitscope
