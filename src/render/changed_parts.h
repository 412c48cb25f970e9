// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/zero_array.h"
#include "mesh/render_mesh.h"
#include "render/index_runs.h"

namespace hitscope {

/// Where a target is not as it was: runs of its triangles and edges with all that have a vertex elsewhere
/// than at its original, and a few beside them. What is drawn of the original over the deformed follows the
/// dents, not the mesh.
class ChangedParts {
public:
    explicit ChangedParts(std::shared_ptr<const RenderMesh> mesh);

    /// These render vertices have moved, or share a face with one that has. Costs what they are.
    void note(std::span<const std::uint32_t> renderVertices);

    // Cost what was noted since they were last asked for, and a little for all that ever was.
    [[nodiscard]] std::span<const IndexRun> triangles() const;
    [[nodiscard]] std::span<const IndexRun> edges() const;

private:
    struct Run {
        std::uint32_t first;  ///< triangle or edge
        std::uint32_t end;
    };
    /// What changed of the triangles and edges whose lowest vertex is in a block of neighbouring vertices.
    struct Block {
        std::uint32_t place = 0;  ///< its first vertex over how many it has
        bool isDirty = false;
        std::vector<Run> triangles;
        std::vector<Run> edges;
    };
    void mark(std::uint32_t vertex);
    void collect() const;
    [[nodiscard]] std::vector<Run> changedIn(std::span<const std::uint32_t> elements, std::size_t size,
                                             Run among, std::uint32_t block) const;
    [[nodiscard]] std::vector<IndexRun> joined(std::vector<Run> Block::*runs, std::size_t size) const;

    std::shared_ptr<const RenderMesh> m_mesh;
    std::vector<bool> m_vertices;        ///< that were noted
    ZeroArray<std::uint32_t> m_blockOf;  ///< by place in the mesh: 1 + index of its block; 0: nothing changed
    mutable std::vector<Block> m_blocks;
    mutable std::vector<std::uint32_t> m_dirty;  ///< of m_blocks
    mutable std::vector<IndexRun> m_triangles;   ///< of the index buffer
    mutable std::vector<IndexRun> m_edges;       ///< of that of edges
};

}  // namespace hitscope
