// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace hitscope {

// What a file may make of the meshes it places: what is more does not fit into the memory that the worker may
// take, so it is refused before any of it is made.
inline constexpr std::uint64_t kMostVertices = 50'000'000;
inline constexpr std::uint64_t kMostCorners = 200'000'000;
inline constexpr std::uint64_t kMostInstances = 1'000'000;

/// What a node comes to with all that is below it.
struct NodeCounts {
    std::uint64_t nodes = 1;
    std::uint64_t numbers = 0;  ///< indices of faces' corners

    void add(const NodeCounts& other) {
        constexpr std::uint64_t kVeryMany = 1ull << 40;  // far below where sums would overflow
        nodes = std::min(nodes + other.nodes, kVeryMany);
        numbers = std::min(numbers + other.numbers, kVeryMany);
    }
    [[nodiscard]] bool tooMany() const { return nodes > kMostInstances || numbers > kMostCorners; }
};

/// Adds to each node's own counts those of its parts, as often as it has each: parts[n] are indices of nodes.
/// False: a node is a part of itself.
[[nodiscard]] bool addUpParts(const std::vector<std::vector<std::size_t>>& parts,
                              std::vector<NodeCounts>& counts);

}  // namespace hitscope
