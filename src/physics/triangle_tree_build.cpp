// SPDX-License-Identifier: GPL-3.0-or-later
// How a TriangleTree is made.
#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <limits>

#include "core/finite.h"
#include "core/give_up.h"
#include "core/median_split.h"
#include "core/parallel.h"
#include "core/raw_vector.h"
#include "physics/triangle_tree.h"

namespace hitscope::physics {
namespace {

constexpr std::size_t kTrianglesAThread = 16384;  // fewer are done sooner than a thread is started
constexpr std::size_t kLeavesAThread = 512;
constexpr std::size_t kBetween = 4096;  // triangles or leaves: looks whether to go on

/// The triangles' centres.
RawVector<PlacedItem> itemsOf(std::span<const glm::vec3> vertices, std::span<const std::uint32_t> corners) {
    RawVector<PlacedItem> items(corners.size() / 3);
    std::atomic<std::size_t> leftOut = 0;
    inWatchedParts(items.size(), kTrianglesAThread, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const std::uint32_t* const c = &corners[3 * i];
            const bool isKnown = std::max({c[0], c[1], c[2]}) < vertices.size();
            const glm::vec3 centre =
                isKnown ? vertices[c[0]] / 3.0f + vertices[c[1]] / 3.0f + vertices[c[2]] / 3.0f
                        : glm::vec3(std::numeric_limits<float>::infinity());
            items[i] = {centre, static_cast<std::uint32_t>(i)};
            if (!isFinite(centre)) {
                ++leftOut;
            }
        }
    });
    if (leftOut > 0) {
        std::erase_if(items, [](const PlacedItem& item) { return !isFinite(item.at); });
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
            many[i] = size + i <= TriangleTree::kLeafTriangles ? 0 : many[i];
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
    std::span<PlacedItem> items;
    std::span<Node> nodes;
    Shape& shape;

    /// Where a subtree begins.
    struct Start {
        std::size_t item;
        std::uint32_t node;
        std::uint32_t leaf;
    };

    /// Of `count` items, into the nodes from `start` on: a node, its left half, its right one. Returns the
    /// index behind them.
    std::uint32_t build(const Start& start, std::size_t count, std::size_t threads) {
        const std::span<PlacedItem> part = items.subspan(start.item, count);
        Node& node = nodes[start.node];
        if (count <= kLeafTriangles) {
            node.first = start.leaf;
            node.count = static_cast<std::uint32_t>(count);
            arrange(part);
            makeLeaf(node, start.item);
            return start.node + 1;
        }
        if (count > kBetween) {
            mayGiveUp();
        }
        const std::size_t half = count / 2;
        splitOnLongestAxis(part, half);
        const Start left{start.item, start.node + 1, start.leaf};
        const auto rightOf = [&](std::uint32_t behindLeft) -> Start {
            const std::uint32_t leaves = (behindLeft - left.node + 1) / 2;  // each inner node joins two
            return {start.item + half, behindLeft, start.leaf + leaves};
        };
        std::uint32_t end = 0;
        if (threads > 1 && count >= kTrianglesAThread) {
            node.first = left.node + nodesOf(half);
            bothAtOnce([&] { build(left, half, threads / 2); },
                       [&] { end = build(rightOf(node.first), count - half, threads - threads / 2); });
        } else {
            node.first = build(left, half, 1);
            end = build(rightOf(node.first), count - half, 1);
        }
        shape.parents[left.node] = start.node;
        shape.parents[node.first] = start.node;
        node.bounds = nodes[left.node].bounds;
        node.bounds.add(nodes[node.first].bounds);
        return end;
    }

    /// Orders the triangles of a leaf as if it went on to be split, and few as they are numbered.
    static void arrange(std::span<PlacedItem> part) {
        if (part.size() > kFewTriangles) {
            const std::size_t half = part.size() / 2;
            splitOnLongestAxis(part, half);
            arrange(part.first(half));
            arrange(part.subspan(half));
        } else {
            std::sort(part.begin(), part.end(),
                      [](const PlacedItem& a, const PlacedItem& b) { return a.index < b.index; });
        }
    }

    void makeLeaf(Node& node, std::size_t begin) {
        shape.leaves[node.first].firstTriangle = static_cast<std::uint32_t>(begin);
        for (std::size_t i = begin; i < begin + node.count; ++i) {
            shape.triangles[i] = items[i].index;
            for (std::size_t corner = 0; corner < 3; ++corner) {
                node.bounds.add(vertices[corners[std::size_t{3} * items[i].index + corner]]);
            }
        }
    }

    /// Where the vertices of the leaf that is looked at come among them; a hash table.
    struct Place {
        std::uint32_t vertex;
        std::uint32_t leaf;  ///< and one: of which it is
        std::uint8_t place;
    };
    using Places = std::array<Place, std::bit_ceil(6 * kLeafTriangles)>;

    /// Lists the vertices of each leaf.
    void nameVertices() {
        const std::size_t leaves = shape.leaves.size() - 1;
        std::vector<std::vector<std::uint32_t>> named(std::max<std::size_t>(leaves / kLeavesAThread, 1));
        const auto endOf = [&](std::size_t part) { return leaves * part / named.size(); };
        const auto forEachPart = [&](const auto& work) {
            inParts(named.size(), 1, [&work](std::size_t begin, std::size_t end) {
                for (std::size_t part = begin; part < end; ++part) {
                    work(part);
                }
            });
        };
        forEachPart([&](std::size_t part) {
            Places places{};
            for (std::size_t leaf = endOf(part); leaf < endOf(part + 1); ++leaf) {
                mayGiveUp(leaf, kBetween);
                nameVertices(leaf, named[part], places);
            }
        });
        std::vector<std::size_t> starts(named.size() + 1, 0);
        for (std::size_t part = 0; part < named.size(); ++part) {
            starts[part + 1] = starts[part] + named[part].size();
        }
        shape.vertices.resize(starts.back());
        shape.leaves[leaves].firstVertex = static_cast<std::uint32_t>(starts.back());
        forEachPart([&](std::size_t part) {
            std::copy(named[part].begin(), named[part].end(),
                      shape.vertices.begin() + static_cast<std::ptrdiff_t>(starts[part]));
            for (std::size_t leaf = endOf(part); leaf < endOf(part + 1); ++leaf) {
                shape.leaves[leaf].firstVertex += static_cast<std::uint32_t>(starts[part]);
            }
        });
    }

    /// Appends the vertices of a leaf.
    void nameVertices(std::size_t leaf, std::vector<std::uint32_t>& named, Places& places) {
        const std::size_t first = named.size();
        const auto stamp = static_cast<std::uint32_t>(leaf + 1);
        shape.leaves[leaf].firstVertex = static_cast<std::uint32_t>(first);
        for (std::size_t i = shape.leaves[leaf].firstTriangle; i < shape.leaves[leaf + 1].firstTriangle;
             ++i) {
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const std::uint32_t vertex = corners[std::size_t{3} * shape.triangles[i] + corner];
                std::size_t slot = vertex % places.size();
                while (places[slot].leaf == stamp && places[slot].vertex != vertex) {
                    slot = (slot + 1) % places.size();
                }
                if (places[slot].leaf != stamp) {
                    places[slot] = {vertex, stamp, static_cast<std::uint8_t>(named.size() - first)};
                    named.push_back(vertex);
                }
                shape.places[i][corner] = places[slot].place;
            }
        }
    }

    void markUsed() {
        shape.isUsed.assign(vertices.size(), false);
        for (const std::uint32_t vertex : shape.vertices) {
            shape.isUsed[vertex] = true;
        }
    }

    /// Calls `visit(run, node)` for the leaves' nodes and each run that they have a vertex of.
    template <class Visit>
    void forEachRun(const Visit& visit) const {
        std::array<std::uint32_t, 3 * kLeafTriangles> runs{};
        for (std::uint32_t node = 0; node < nodes.size(); ++node) {
            if (nodes[node].count == 0) {
                continue;
            }
            const std::size_t end = shape.leaves[nodes[node].first + std::size_t{1}].firstVertex;
            std::size_t count = 0;
            for (std::size_t i = shape.leaves[nodes[node].first].firstVertex; i < end; ++i) {
                const auto run = static_cast<std::uint32_t>(shape.vertices[i] / RunPositions::kRun);
                const auto known = runs.begin() + static_cast<std::ptrdiff_t>(count);
                if (std::find(runs.begin(), known, run) == known) {
                    runs[count++] = run;
                    visit(run, node);
                }
            }
        }
    }

    void listRuns() {
        std::vector<std::uint32_t>& starts = shape.runStarts;
        starts.assign(vertices.size() / RunPositions::kRun + 3, 0);
        forEachRun([&starts](std::uint32_t run, std::uint32_t /*node*/) { ++starts[run + 2]; });
        for (std::size_t run = 2; run < starts.size(); ++run) {
            starts[run] += starts[run - 1];
        }
        shape.leafNodes.resize(starts.back());
        // Each start moves to the end of its run, where the next one starts.
        forEachRun([&](std::uint32_t run, std::uint32_t node) { shape.leafNodes[starts[run + 1]++] = node; });
        starts.pop_back();
    }
};

TriangleTree::TriangleTree(std::span<const glm::vec3> vertices, std::span<const std::uint32_t> corners) {
    RawVector<PlacedItem> items = itemsOf(vertices, corners);
    if (items.empty()) {
        return;
    }
    const std::uint32_t nodes = nodesOf(items.size());
    auto shape = std::make_shared<Shape>();
    auto made = std::make_shared<std::vector<Node>>(nodes);
    shape->triangles.resize(items.size());
    shape->places.resize(items.size());
    shape->leaves.resize((std::size_t{nodes} + 1) / 2 + 1);
    shape->leaves.back().firstTriangle = static_cast<std::uint32_t>(items.size());
    shape->parents.resize(nodes);
    Builder builder{vertices, corners, items, *made, *shape};
    builder.build({0, 0, 0}, items.size(), usefulThreads());
    builder.nameVertices();
    builder.markUsed();
    builder.listRuns();
    m_original = std::move(made);
    m_nodes = RunArray<Node>(*m_original);
    m_shape = std::move(shape);
}

}  // namespace hitscope::physics
