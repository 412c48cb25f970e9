// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

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

/// Which clusters of a target a hit can reach, as its vertices move. The spheres only ever grow, and by no
/// more than the hits so far could have moved a vertex (max_magnitude each, and never beyond the hit's own
/// reach), so a vertex pushed far out is still found and hits piling on one spot do not swell the spheres
/// without end. A tree over the clusters makes a query cost what it finds, not what the mesh has.
class ClusterReach {
public:
    explicit ClusterReach(std::span<const Cluster> clusters);

    /// The vertices of the clusters within hit.constants.maxDistance of hit.point, as sorted, merged ranges;
    /// grows these clusters' spheres by what the hit can do. Call once for each hit, in order.
    [[nodiscard]] std::vector<VertexRange> advance(const Hit& hit);

private:
    struct Node {
        glm::dvec3 centre{0.0};
        double radius = -1.0;
        std::uint32_t firstChild = 0;  ///< children are firstChild and firstChild + 1; 0: a leaf
        VertexRange range;             ///< leaf: its vertices
    };
    void build(std::span<const Cluster> clusters, std::size_t node);
    void visit(std::size_t node, const Hit& hit, std::vector<VertexRange>& found);
    void encloseChildren(Node& node) const;

    std::vector<Node> m_nodes;  ///< the root first; empty when there are no clusters
};

}  // namespace hitscope
