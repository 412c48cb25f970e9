// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "deform/cluster_reach.h"

namespace hitscope {

/// Vertex ranges gathered over many hits. Holds no more than a small multiple of the different ranges,
/// however often they are added.
class ChangedRanges {
public:
    void add(std::span<const VertexRange> ranges);
    [[nodiscard]] bool empty() const { return m_ranges.empty(); }
    /// All that was added, in no order.
    [[nodiscard]] std::span<const VertexRange> ranges() const { return m_ranges; }
    /// All that was added, sorted and merged; nothing is left.
    [[nodiscard]] std::vector<VertexRange> take();

private:
    std::vector<VertexRange> m_ranges;
    std::size_t m_mergeAt = 0;  ///< entries at which the next merge pays
};

}  // namespace hitscope
