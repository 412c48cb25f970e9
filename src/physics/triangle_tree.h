// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "core/bounds.h"
#include "physics/run_array.h"

namespace hitscope::physics {

/// A tree of boxes over a mesh's triangles whose boxes can follow the vertices. Bullet's own tree is
/// quantized to the box it was built in, which dents leave, and its partial refit scans all of its subtrees
/// and leaves the nodes above them stale; this one costs by what was touched. Copies share all that no
/// refit changed.
class TriangleTree {
public:
    static constexpr std::size_t kLeafTriangles = 32;  ///< at most
    static constexpr std::size_t kFewTriangles = 4;    ///< so many come as they are numbered
    using Corners = std::array<std::uint32_t, 3>;      ///< vertices of a triangle

    /// Some vertices of a run moved.
    struct MovedRun {
        std::uint32_t run;  ///< see RunPositions
        Bounds before;      ///< where those that moved were
    };

    TriangleTree() = default;
    /// `corners`: 3 a triangle. Triangles with an index out of range or a corner that is not finite are left
    /// out. Time n log n: about 0.2 s a million, shared among the processors.
    TriangleTree(std::span<const glm::vec3> vertices, std::span<const std::uint32_t> corners);

    [[nodiscard]] bool empty() const { return !m_original; }
    [[nodiscard]] Bounds bounds() const { return empty() ? Bounds{} : m_nodes[0].bounds; }

    /// A triangle has that vertex.
    [[nodiscard]] bool uses(std::uint32_t vertex) const { return !empty() && m_shape->isUsed[vertex]; }

    /// Corrects the boxes around vertices that moved. Each run comes once. Costs by the leaves that have a
    /// vertex of the runs, and by how far up the boxes change.
    void refit(const RunPositions& vertices, std::span<const MovedRun> moved);
    /// All vertices are where they were when it was made. Costs by what refit() changed.
    void reset() { m_nodes.reset(); }

    /// A triangle that is visited.
    struct Visited {
        std::uint32_t triangle;
        Corners corners;
        std::uint32_t leaf;
        std::uint32_t place;  ///< in the tree's order
    };
    /// Calls `visit(visited)` for the triangles of every leaf whose box, and all boxes above it, `accept`s:
    /// leaves nearer along `direction` first (roughly), the triangles of a leaf in the tree's order. Zero:
    /// all in the tree's order.
    template <class Accept, class Visit>
    void visit(const glm::vec3& direction, const Accept& accept, const Visit& visit) const;
    /// The same with the triangles of a leaf, too, nearer ones first, by fours: takes longer.
    template <class Accept, class Visit>
    void visitInOrder(const RunPositions& vertices, const glm::vec3& direction, const Accept& accept,
                      const Visit& visit) const;
    /// Whether visitInOrder() comes to `a` before it comes to `b`; both are of the same leaf.
    [[nodiscard]] bool comesFirst(const Visited& a, const Visited& b, const RunPositions& vertices,
                                  const glm::vec3& direction) const;

private:
    struct Builder;
    struct Node {
        Bounds bounds;
        std::uint32_t first = 0;  ///< a leaf: its number; else: the second child, the first comes next
        std::uint32_t count = 0;  ///< triangles of a leaf; 0: not a leaf
    };
    using LeafOrder = std::array<std::uint32_t, kLeafTriangles>;
    [[nodiscard]] static bool isFirst(const Bounds& left, const Bounds& right, const glm::vec3& direction) {
        const glm::vec3 apart = (right.min - left.min) + (right.max - left.max);
        return glm::dot(apart, direction) >= 0.0f;
    }
    struct Leaf {
        std::uint32_t firstTriangle = 0;  ///< of Shape::triangles
        std::uint32_t firstVertex = 0;    ///< of Shape::vertices
    };
    /// What stays as it is while vertices move. A leaf names each of its vertices once, so that its box is
    /// found by looking at few of them.
    struct Shape {
        std::vector<std::uint32_t> triangles;             ///< the leaves'
        std::vector<std::array<std::uint8_t, 3>> places;  ///< of their corners among their leaf's vertices
        std::vector<std::uint32_t> vertices;              ///< the leaves'
        std::vector<Leaf> leaves;                         ///< and one behind the last
        std::vector<std::uint32_t> parents;               ///< of the nodes; the root's is the root
        std::vector<std::uint32_t> runStarts;             ///< run -> first of its leafNodes; and one more
        std::vector<std::uint32_t> leafNodes;             ///< nodes of the leaves with a vertex of the run
        std::vector<bool> isUsed;                         ///< by vertex: it is one of `vertices`

        [[nodiscard]] Corners cornersOf(const Leaf& leaf, std::size_t triangle) const {
            const std::uint32_t* const of = &vertices[leaf.firstVertex];
            const std::array<std::uint8_t, 3>& place = places[triangle];
            return {of[place[0]], of[place[1]], of[place[2]]};
        }
    };
    /// Calls `visitLeaf(node)` in the order of visit().
    template <class Accept, class VisitLeaf>
    void visitLeaves(const glm::vec3& direction, const Accept& accept, const VisitLeaf& visitLeaf) const;
    [[nodiscard]] Visited visited(const Node& node, std::size_t place) const {
        return {m_shape->triangles[place], m_shape->cornersOf(m_shape->leaves[node.first], place), node.first,
                static_cast<std::uint32_t>(place)};
    }
    /// The places of a leaf's triangles, nearer ones first.
    [[nodiscard]] LeafOrder orderOf(std::uint32_t leaf, const RunPositions& vertices,
                                    const glm::vec3& direction) const;
    void findLeaves(std::span<const MovedRun> moved);
    void refitLeaves(const RunPositions& vertices);
    void refitParents();
    void take(std::uint32_t node, const Bounds& bounds);

    std::shared_ptr<const std::vector<Node>> m_original;  ///< null: there are no triangles
    RunArray<Node> m_nodes;                               ///< of the original
    std::shared_ptr<const Shape> m_shape;
    // Of the refit() that runs.
    std::vector<std::uint32_t> m_found;  ///< nodes whose boxes are to be looked at
    std::vector<std::uint32_t> m_above;  ///< parents of nodes whose boxes changed
    std::vector<bool> m_isFound;         ///< node is in one of the two
};

template <class Accept, class VisitLeaf>
void TriangleTree::visitLeaves(const glm::vec3& direction, const Accept& accept,
                               const VisitLeaf& visitLeaf) const {
    // The median splits keep the tree within 32 levels.
    std::uint32_t waiting[64];
    int count = 0;
    if (!empty()) {
        waiting[count++] = 0;
    }
    while (count > 0) {
        const std::uint32_t index = waiting[--count];
        const Node& node = m_nodes[index];
        if (!accept(node.bounds)) {
            continue;
        }
        if (node.count > 0) {
            visitLeaf(node);
        } else {
            const Bounds& left = m_nodes[index + 1].bounds;
            const Bounds& right = m_nodes[node.first].bounds;
            const bool leftFirst = isFirst(left, right, direction);
            waiting[count++] = leftFirst ? node.first : index + 1;
            waiting[count++] = leftFirst ? index + 1 : node.first;
        }
    }
}

template <class Accept, class Visit>
void TriangleTree::visit(const glm::vec3& direction, const Accept& accept, const Visit& visit) const {
    visitLeaves(direction, accept, [&](const Node& node) {
        const std::size_t first = m_shape->leaves[node.first].firstTriangle;
        for (std::size_t i = first; i < first + node.count; ++i) {
            visit(visited(node, i));
        }
    });
}

template <class Accept, class Visit>
void TriangleTree::visitInOrder(const RunPositions& vertices, const glm::vec3& direction,
                                const Accept& accept, const Visit& visit) const {
    visitLeaves(direction, accept, [&](const Node& node) {
        const LeafOrder order = orderOf(node.first, vertices, direction);
        for (std::size_t i = 0; i < node.count; ++i) {
            visit(visited(node, order[i]));
        }
    });
}

}  // namespace hitscope::physics
