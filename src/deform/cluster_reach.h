// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/bounds.h"
#include "deform/hit.h"
#include "mesh/render_mesh.h"

namespace hitscope {

/// A run of render vertices, [first, first + count).
struct VertexRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    bool operator==(const VertexRange&) const = default;
};

/// Sorts, and joins ranges that touch or overlap.
[[nodiscard]] std::vector<VertexRange> merged(std::vector<VertexRange> ranges);

/// Which clusters of a target a hit can reach, as its vertices move. The spheres only ever grow, by what the
/// hits so far could have moved a vertex (max_magnitude each), so a vertex pushed far out is still found. A
/// tree over the clusters makes a query cost what it finds, not what the mesh has.
class ClusterReach {
public:
    explicit ClusterReach(std::span<const Cluster> clusters);

    /// The vertices of the clusters within hit.constants.maxDistance of hit.point, as sorted, merged ranges;
    /// grows these clusters' spheres by what the hit can do. Call once for each hit, in order.
    [[nodiscard]] std::vector<VertexRange> advance(const Hit& hit);

private:
    struct Node {
        Sphere bounds;
        std::uint32_t firstChild = 0;  ///< inner node: children are firstChild and firstChild + 1
        std::uint32_t parent = 0;
        VertexRange range;  ///< leaf: its vertices; inner: count == 0
    };
    std::vector<Node> m_nodes;
};

}  // namespace hitscope
