// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/triangle_tree.h"

#include <algorithm>
#include <array>
#include <glm/vector_relational.hpp>

namespace hitscope::physics {
namespace {

// On a fine mesh every look is a cache miss. Told beforehand what comes, the memory works on several at once:
// first a leaf's list of vertices, then the vertices.
constexpr std::size_t kListsAhead = 8;
constexpr std::size_t kVerticesAhead = 4;
// Most vertices of so many leaves have just been moved: the caches have them.
constexpr std::size_t kManyLeaves = 128;

bool isSame(const Bounds& a, const Bounds& b) {
    return a.min == b.min && a.max == b.max;
}

bool overlap(const Bounds& a, const Bounds& b) {
    return glm::all(glm::lessThanEqual(a.min, b.max)) && glm::all(glm::lessThanEqual(b.min, a.max));
}

/// By value throughout, so that it stays in registers.
Bounds boundsOf(const RunPositions& vertices, std::span<const std::uint32_t> some) {
    Bounds bounds;
    for (const std::uint32_t vertex : some) {
        bounds.add(vertices[vertex]);
    }
    return bounds;
}

}  // namespace

TriangleTree::LeafOrder TriangleTree::orderOf(std::uint32_t leaf, const RunPositions& vertices,
                                              const glm::vec3& direction) const {
    struct Part {
        std::size_t begin;
        std::size_t count;
    };
    const auto boundsOfPart = [&](const Part& part) {
        Bounds bounds;
        for (std::size_t i = part.begin; i < part.begin + part.count; ++i) {
            for (const std::uint32_t corner : m_shape->cornersOf(m_shape->leaves[leaf], i)) {
                bounds.add(vertices[corner]);
            }
        }
        return bounds;
    };
    LeafOrder order{};
    std::size_t ordered = 0;
    const std::size_t begin = m_shape->leaves[leaf].firstTriangle;
    std::array<Part, 2 * kLeafTriangles> waiting{};
    std::size_t count = 0;
    waiting[count++] = {begin, m_shape->leaves[leaf + std::size_t{1}].firstTriangle - begin};
    while (count > 0) {
        const Part part = waiting[--count];
        if (part.count <= kFewTriangles) {
            for (std::size_t i = part.begin; i < part.begin + part.count; ++i) {
                order[ordered++] = static_cast<std::uint32_t>(i);
            }
            continue;
        }
        const Part left{part.begin, part.count / 2};
        const Part right{part.begin + left.count, part.count - left.count};
        const bool leftFirst = isFirst(boundsOfPart(left), boundsOfPart(right), direction);
        waiting[count++] = leftFirst ? right : left;
        waiting[count++] = leftFirst ? left : right;
    }
    return order;
}

bool TriangleTree::comesFirst(const Visited& a, const Visited& b, const RunPositions& vertices,
                              const glm::vec3& direction) const {
    const LeafOrder order = orderOf(a.leaf, vertices, direction);
    return std::find(order.begin(), order.end(), a.place) < std::find(order.begin(), order.end(), b.place);
}

void TriangleTree::refit(const RunPositions& vertices, std::span<const MovedRun> moved) {
    if (empty() || moved.empty()) {
        return;
    }
    m_isFound.resize(m_nodes.size(), false);
    findLeaves(moved);
    refitLeaves(vertices);
    while (!m_above.empty()) {
        refitParents();
    }
}

void TriangleTree::findLeaves(std::span<const MovedRun> moved) {
    m_found.clear();
    for (const MovedRun& run : moved) {
        if (std::size_t{run.run} + 1 >= m_shape->runStarts.size()) {
            continue;  // no triangle has a vertex of it
        }
        const std::uint32_t first = m_shape->runStarts[run.run];
        const std::span<const std::uint32_t> leaves =
            std::span(m_shape->leafNodes).subspan(first, m_shape->runStarts[run.run + 1] - first);
        for (const std::uint32_t node : leaves) {
            __builtin_prefetch(&m_nodes[node]);
        }
        for (const std::uint32_t node : leaves) {
            if (!m_isFound[node] && overlap(m_nodes[node].bounds, run.before)) {
                __builtin_prefetch(&m_shape->leaves[m_nodes[node].first]);
                __builtin_prefetch(&m_shape->parents[node]);
                m_isFound[node] = true;
                m_found.push_back(node);
            }
        }
    }
}

void TriangleTree::refitLeaves(const RunPositions& vertices) {
    const auto verticesOf = [this](std::uint32_t node) {
        const Leaf* const leaf = &m_shape->leaves[m_nodes[node].first];
        return std::span(m_shape->vertices)
            .subspan(leaf->firstVertex, leaf[1].firstVertex - std::size_t{leaf->firstVertex});
    };
    const bool isSmall = m_found.size() < kManyLeaves;
    for (std::size_t i = 0; i < m_found.size(); ++i) {
        if (i + kListsAhead < m_found.size()) {
            __builtin_prefetch(verticesOf(m_found[i + kListsAhead]).data());
        }
        if (isSmall && i + kVerticesAhead < m_found.size()) {
            for (const std::uint32_t vertex : verticesOf(m_found[i + kVerticesAhead])) {
                __builtin_prefetch(&vertices[vertex]);
            }
        }
        take(m_found[i], boundsOf(vertices, verticesOf(m_found[i])));
    }
}

/// A level up, or where leaves are not equally deep, two of them.
void TriangleTree::refitParents() {
    m_found.swap(m_above);
    m_above.clear();
    for (const std::uint32_t node : m_found) {
        Bounds bounds = m_nodes[node + 1].bounds;
        bounds.add(m_nodes[m_nodes[node].first].bounds);
        take(node, bounds);
    }
}

/// A node that was found has this box.
void TriangleTree::take(std::uint32_t node, const Bounds& bounds) {
    m_isFound[node] = false;
    if (isSame(m_nodes[node].bounds, bounds)) {
        return;
    }
    m_nodes.change(node).bounds = bounds;
    const std::uint32_t parent = m_shape->parents[node];
    if (parent != node && !m_isFound[parent]) {
        __builtin_prefetch(&m_nodes[parent]);
        __builtin_prefetch(&m_shape->parents[parent]);
        m_isFound[parent] = true;
        m_above.push_back(parent);
    }
}

}  // namespace hitscope::physics
