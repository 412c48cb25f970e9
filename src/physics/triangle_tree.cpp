// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <glm/vector_relational.hpp>

#include "core/finite.h"

namespace hitscope::physics {
namespace {

constexpr std::size_t kLeafTriangles = 4;
constexpr std::size_t kLeavesAhead = 4;  // whose corners are asked for before they are looked at

bool overlap(const Bounds& a, const Bounds& b) {
    return glm::all(glm::lessThanEqual(a.min, b.max)) && glm::all(glm::lessThanEqual(b.min, a.max));
}

}  // namespace

struct TriangleTree::Item {
    glm::vec3 centre;
    std::uint32_t triangle;
};

TriangleTree::TriangleTree(std::span<const glm::vec3> vertices, std::span<const std::uint32_t> corners) {
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
    if (items.empty()) {
        return;
    }
    m_nodes.reserve(items.size());
    build(items, 0);
    m_nodes.shrink_to_fit();
    auto order = std::make_shared<std::vector<std::uint32_t>>();
    order->reserve(items.size());
    auto ordered = std::make_shared<std::vector<std::uint32_t>>();
    ordered->reserve(3 * items.size());
    for (const Item& item : items) {
        order->push_back(item.triangle);
        const auto corner = corners.begin() + 3 * static_cast<std::ptrdiff_t>(item.triangle);
        ordered->insert(ordered->end(), corner, corner + 3);
    }
    m_order = std::move(order);
    m_corners = std::move(ordered);
    constexpr float kEverywhere = std::numeric_limits<float>::infinity();
    refit(vertices, {glm::vec3(-kEverywhere), glm::vec3(kEverywhere)});
}

std::uint32_t TriangleTree::build(std::span<Item> items, std::uint32_t begin) {
    const auto index = static_cast<std::uint32_t>(m_nodes.size());
    Node& node = m_nodes.emplace_back();
    // Not known yet: until the first refit every box overlaps every region.
    constexpr float kEverywhere = std::numeric_limits<float>::infinity();
    node.bounds = {glm::vec3(-kEverywhere), glm::vec3(kEverywhere)};
    if (items.size() <= kLeafTriangles) {
        node.first = begin;
        node.count = static_cast<std::uint32_t>(items.size());
        return index;
    }
    Bounds centres;
    for (const Item& item : items) {
        centres.add(item.centre);
    }
    const glm::vec3 size = centres.size();
    const int axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
    const std::size_t half = items.size() / 2;
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                     [axis](const Item& a, const Item& b) {
                         // The triangle decides between equals, so that every library splits the same.
                         return a.centre[axis] != b.centre[axis] ? a.centre[axis] < b.centre[axis]
                                                                 : a.triangle < b.triangle;
                     });
    build(items.first(half), begin);
    const std::uint32_t right = build(items.subspan(half), begin + static_cast<std::uint32_t>(half));
    m_nodes[index].first = right;
    return index;
}

void TriangleTree::refit(std::span<const glm::vec3> vertices, const Bounds& region) {
    findOverlapping(region);
    const auto cornersOf = [this](const Node& leaf) {
        return std::span(*m_corners).subspan(std::size_t{3} * leaf.first, std::size_t{3} * leaf.count);
    };
    // Children were found after their parents, so they come first here.
    for (std::size_t i = m_found.size(); i-- > 0;) {
        if (i >= kLeavesAhead && m_nodes[m_found[i - kLeavesAhead]].count > 0) {
            for (const std::uint32_t corner : cornersOf(m_nodes[m_found[i - kLeavesAhead]])) {
                __builtin_prefetch(&vertices[corner]);
            }
        }
        Node& node = m_nodes[m_found[i]];
        Bounds bounds;
        if (node.count > 0) {
            for (const std::uint32_t corner : cornersOf(node)) {
                bounds.add(vertices[corner]);
            }
        } else {
            bounds = m_nodes[m_found[i] + 1].bounds;
            bounds.add(m_nodes[node.first].bounds);
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
    if (!empty()) {
        waiting[count++] = 0;
    }
    while (count > 0) {
        const std::uint32_t index = waiting[--count];
        const Node& node = m_nodes[index];
        if (!overlap(node.bounds, region)) {
            continue;
        }
        m_found.push_back(index);
        if (node.count > 0) {
            __builtin_prefetch(&(*m_corners)[std::size_t{3} * node.first]);
        } else {
            __builtin_prefetch(&m_nodes[node.first]);
            waiting[count++] = node.first;
            waiting[count++] = index + 1;
        }
    }
}

}  // namespace hitscope::physics
