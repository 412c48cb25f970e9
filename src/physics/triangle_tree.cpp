// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/triangle_tree.h"

#include <algorithm>
#include <array>
#include <glm/vector_relational.hpp>

#include "core/finite.h"
#include "core/parallel.h"

namespace hitscope::physics {
namespace {

constexpr std::size_t kLeafTriangles = 4;
constexpr std::size_t kTrianglesAThread = 16384;  // fewer are done sooner than a thread is started
constexpr std::size_t kLeavesAhead = 4;           // whose corners are asked for before they are looked at

bool overlap(const Bounds& a, const Bounds& b) {
    return glm::all(glm::lessThanEqual(a.min, b.max)) && glm::all(glm::lessThanEqual(b.min, a.max));
}

}  // namespace

namespace {

struct Item {
    glm::vec3 centre;
    std::uint32_t triangle;
};

std::vector<Item> itemsOf(std::span<const glm::vec3> vertices, std::span<const std::uint32_t> corners) {
    std::vector<Item> items;
    items.reserve(corners.size() / 3);
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        const std::uint32_t* c = &corners[i];
        if (std::max({c[0], c[1], c[2]}) >= vertices.size()) {
            continue;
        }
        const glm::vec3 centre = vertices[c[0]] / 3.0f + vertices[c[1]] / 3.0f + vertices[c[2]] / 3.0f;
        if (isFinite(centre)) {
            items.push_back({centre, static_cast<std::uint32_t>(i / 3)});
        }
    }
    return items;
}

/// Of a tree over so many triangles. The halves of neighbouring numbers are neighbouring numbers, so each
/// level has two sizes at most.
std::uint32_t nodesOf(std::size_t triangles) {
    std::uint64_t nodes = 0;
    std::array<std::uint64_t, 2> many{1, 0};  // subtrees of `size` and of `size + 1` triangles
    for (std::size_t size = triangles; many[0] + many[1] > 0; size /= 2) {
        nodes += many[0] + many[1];
        for (std::size_t i = 0; i < 2; ++i) {
            many[i] = size + i <= kLeafTriangles ? 0 : many[i];
        }
        const bool isOdd = size % 2 == 1;  // then the halves of `size` differ, and those of `size + 1` do not
        const std::uint64_t smaller = isOdd ? many[0] : 2 * many[0] + many[1];
        const std::uint64_t larger = isOdd ? many[0] + 2 * many[1] : many[1];
        many = {smaller, larger};
    }
    return static_cast<std::uint32_t>(nodes);
}

}  // namespace

struct TriangleTree::Builder {
    std::span<const glm::vec3> vertices;
    std::span<const std::uint32_t> corners;
    std::span<Item> items;
    std::span<Node> nodes;
    std::vector<std::uint32_t>& order;
    std::vector<std::uint32_t>& ordered;

    /// Of items [begin, begin + count), into the nodes from `index` on: a node, its left half, its right one.
    /// Returns the index behind them.
    std::uint32_t build(std::size_t begin, std::size_t count, std::uint32_t index, std::size_t threads) {
        const std::span<Item> part = items.subspan(begin, count);
        Node& node = nodes[index];
        if (count <= kLeafTriangles) {
            node.first = static_cast<std::uint32_t>(begin);
            node.count = static_cast<std::uint32_t>(count);
            makeLeaf(node);
            return index + 1;
        }
        Bounds centres;
        for (const Item& item : part) {
            centres.add(item.centre);
        }
        const glm::vec3 size = centres.size();
        const int axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
        const std::size_t half = count / 2;
        std::nth_element(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(half), part.end(),
                         [axis](const Item& a, const Item& b) {
                             // The triangle decides between equals, so that every library splits the same.
                             return a.centre[axis] != b.centre[axis] ? a.centre[axis] < b.centre[axis]
                                                                     : a.triangle < b.triangle;
                         });
        std::uint32_t end = 0;
        if (threads > 1 && count >= kTrianglesAThread) {
            node.first = index + 1 + nodesOf(half);
            bothAtOnce([&] { build(begin, half, index + 1, threads / 2); },
                       [&] { end = build(begin + half, count - half, node.first, threads - threads / 2); });
        } else {
            node.first = build(begin, half, index + 1, 1);
            end = build(begin + half, count - half, node.first, 1);
        }
        node.bounds = nodes[index + 1].bounds;
        node.bounds.add(nodes[node.first].bounds);
        return end;
    }

    void makeLeaf(Node& leaf) {
        for (std::size_t i = leaf.first; i < std::size_t{leaf.first} + leaf.count; ++i) {
            order[i] = items[i].triangle;
            for (std::size_t corner = 0; corner < 3; ++corner) {
                ordered[3 * i + corner] = corners[std::size_t{3} * items[i].triangle + corner];
                leaf.bounds.add(vertices[ordered[3 * i + corner]]);
            }
        }
    }
};

TriangleTree::TriangleTree(std::span<const glm::vec3> vertices, std::span<const std::uint32_t> corners) {
    std::vector<Item> items = itemsOf(vertices, corners);
    if (items.empty()) {
        return;
    }
    m_nodes = std::make_shared<std::vector<Node>>(nodesOf(items.size()));
    auto order = std::make_shared<std::vector<std::uint32_t>>(items.size());
    auto ordered = std::make_shared<std::vector<std::uint32_t>>(3 * items.size());
    Builder{vertices, corners, items, *m_nodes, *order, *ordered}.build(0, items.size(), 0, usefulThreads());
    m_order = std::move(order);
    m_corners = std::move(ordered);
}

void TriangleTree::makeOwn() {
    if (m_nodes.use_count() > 1) {
        m_nodes = std::make_shared<std::vector<Node>>(*m_nodes);
    }
}

void TriangleTree::refit(std::span<const glm::vec3> vertices, const Bounds& region) {
    if (empty()) {
        return;
    }
    makeOwn();
    std::vector<Node>& nodes = *m_nodes;
    findOverlapping(region);
    const auto cornersOf = [this](const Node& leaf) {
        return std::span(*m_corners).subspan(std::size_t{3} * leaf.first, std::size_t{3} * leaf.count);
    };
    // Children were found after their parents, so they come first here.
    for (std::size_t i = m_found.size(); i-- > 0;) {
        if (i >= kLeavesAhead && nodes[m_found[i - kLeavesAhead]].count > 0) {
            for (const std::uint32_t corner : cornersOf(nodes[m_found[i - kLeavesAhead]])) {
                __builtin_prefetch(&vertices[corner]);
            }
        }
        Node& node = nodes[m_found[i]];
        Bounds bounds;
        if (node.count > 0) {
            for (const std::uint32_t corner : cornersOf(node)) {
                bounds.add(vertices[corner]);
            }
        } else {
            bounds = nodes[m_found[i] + 1].bounds;
            bounds.add(nodes[node.first].bounds);
        }
        node.bounds = bounds;
    }
}

/// On a fine mesh every look is a cache miss; told beforehand what comes, the memory works on several at
/// once.
void TriangleTree::findOverlapping(const Bounds& region) {
    m_found.clear();
    std::uint32_t waiting[64];  // the median splits keep the tree within 32 levels
    int count = 0;
    waiting[count++] = 0;
    const std::vector<Node>& nodes = *m_nodes;
    while (count > 0) {
        const std::uint32_t index = waiting[--count];
        const Node& node = nodes[index];
        if (!overlap(node.bounds, region)) {
            continue;
        }
        m_found.push_back(index);
        if (node.count > 0) {
            __builtin_prefetch(&(*m_corners)[std::size_t{3} * node.first]);
        } else {
            __builtin_prefetch(&nodes[node.first]);
            waiting[count++] = node.first;
            waiting[count++] = index + 1;
        }
    }
}

}  // namespace hitscope::physics
