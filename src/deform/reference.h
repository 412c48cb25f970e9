// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "deform/cluster_reach.h"
#include "deform/hit.h"
#include "mesh/render_mesh.h"

namespace hitscope {

/// The paper's Algorithm 3 as it stands: every hit at every vertex, in order, and nothing that saves work.
/// Takes hits.size() * vertices.size() steps; what the reference itself is checked with.
void deformEverywhere(std::span<DynamicVertex> vertices, std::span<const Hit> hits);

/// The C++ deformation of one target, needing no GPU: what the pipelines are held against.
class ReferenceDeformation {
public:
    /// Starts from the mesh's original vertices. `mesh` outlives this.
    explicit ReferenceDeformation(const RenderMesh& mesh);

    /// Applies hits in order (all on this target). Returns the ranges that may have changed, sorted and
    /// merged.
    std::vector<VertexRange> apply(std::span<const Hit> hits);

    [[nodiscard]] std::span<const DynamicVertex> vertices() const { return m_vertices; }

private:
    std::vector<DynamicVertex> m_vertices;
    ClusterReach m_reach;
};

}  // namespace hitscope
