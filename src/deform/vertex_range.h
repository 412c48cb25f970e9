// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace hitscope {

/// A run of render vertices, [first, first + count).
struct VertexRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    bool operator==(const VertexRange&) const = default;
};

/// Sorts, and joins ranges that touch or overlap.
[[nodiscard]] std::vector<VertexRange> merged(std::vector<VertexRange> ranges);

/// Sum of the ranges' vertices.
[[nodiscard]] std::size_t vertexCount(std::span<const VertexRange> ranges);

/// Vertex ranges gathered over many hits. Holds no more than a small multiple of the different ranges,
/// however often they are added.
class ChangedRanges {
public:
    void add(std::span<const VertexRange> ranges);
    [[nodiscard]] bool empty() const { return m_ranges.empty(); }
    /// All that was added, sorted and merged; nothing is left.
    [[nodiscard]] std::vector<VertexRange> take();
    /// Likewise no more than `most` (> 0) vertices, the lowest ones; the others are left.
    [[nodiscard]] std::vector<VertexRange> take(std::size_t most);

private:
    std::vector<VertexRange> m_ranges;
    std::size_t m_mergeAt = 0;  ///< entries at which the next merge pays
};

}  // namespace hitscope
