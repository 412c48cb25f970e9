// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "core/bounds.h"

namespace hitscope::physics {

/// A tree of boxes over a mesh's triangles whose boxes can follow the vertices. Bullet's own tree is
/// quantized to the box it was built in, which dents leave, and its partial refit scans all of its subtrees
/// and leaves the nodes above them stale; this one costs by what was touched. Copies share all until a refit,
/// which gives the one it is called on boxes of its own.
class TriangleTree {
public:
    struct Node {
        Bounds bounds;
        std::uint32_t first = 0;  ///< a leaf: of triangles(); else: the second child, the first comes next
        std::uint32_t count = 0;  ///< triangles of a leaf; 0: not a leaf
    };

    TriangleTree() = default;
    /// `corners`: 3 a triangle. Triangles with an index out of range or a corner that is not finite are left
    /// out. Time n log n: about 0.2 s a million, shared among the processors.
    TriangleTree(std::span<const glm::vec3> vertices, std::span<const std::uint32_t> corners);

    [[nodiscard]] bool empty() const { return !m_nodes; }
    [[nodiscard]] Bounds bounds() const { return empty() ? Bounds{} : m_nodes->front().bounds; }

    /// Vertices moved which were all within `region` before: corrects the boxes above them. Costs by the
    /// triangles around the region and the tree's depth.
    void refit(std::span<const glm::vec3> vertices, const Bounds& region);

    /// Gives a copy boxes of its own now, not with its first refit().
    void makeOwn();

    /// Calls `visit(triangle)` for the triangles of every leaf whose box, and all boxes above it, `accept`s,
    /// those nearer along `direction` first (roughly); zero: in the tree's order.
    template <class Accept, class Visit>
    void visit(const glm::vec3& direction, const Accept& accept, const Visit& visit) const;

private:
    struct Builder;
    void findOverlapping(const Bounds& region);

    std::shared_ptr<std::vector<Node>> m_nodes;                 ///< null: there are no triangles
    std::shared_ptr<const std::vector<std::uint32_t>> m_order;  ///< the leaves' triangles
    /// Their corners, 3 each, in that order: where a fine mesh's are looked up one by one, each is a cache
    /// miss.
    std::shared_ptr<const std::vector<std::uint32_t>> m_corners;
    std::vector<std::uint32_t> m_found;  ///< by refit(): nodes, parents before their children
};

template <class Accept, class Visit>
void TriangleTree::visit(const glm::vec3& direction, const Accept& accept, const Visit& visit) const {
    // The median splits keep the tree within 32 levels.
    std::uint32_t waiting[64];
    int count = 0;
    if (!empty()) {
        waiting[count++] = 0;
    }
    const Node* const nodes = empty() ? nullptr : m_nodes->data();
    while (count > 0) {
        const std::uint32_t index = waiting[--count];
        const Node& node = nodes[index];
        if (!accept(node.bounds)) {
            continue;
        }
        for (std::uint32_t i = 0; i < node.count; ++i) {
            visit((*m_order)[node.first + i]);
        }
        if (node.count == 0) {
            const Bounds& left = nodes[index + 1].bounds;
            const Bounds& right = nodes[node.first].bounds;
            const glm::vec3 apart = (right.min - left.min) + (right.max - left.max);
            const bool leftFirst = glm::dot(apart, direction) >= 0.0f;
            waiting[count++] = leftFirst ? node.first : index + 1;
            waiting[count++] = leftFirst ? index + 1 : node.first;
        }
    }
}

}  // namespace hitscope::physics
