// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/changed_ranges.h"

#include <algorithm>
#include <utility>

namespace hitscope {

namespace {
constexpr std::size_t kLeastMerge = 256;
}

void ChangedRanges::add(std::span<const VertexRange> ranges) {
    m_ranges.insert(m_ranges.end(), ranges.begin(), ranges.end());
    if (m_ranges.size() >= m_mergeAt) {
        m_ranges = merged(std::move(m_ranges));
        m_mergeAt = std::max(kLeastMerge, 2 * m_ranges.size());
    }
}

std::vector<VertexRange> ChangedRanges::take() {
    m_mergeAt = kLeastMerge;
    return merged(std::exchange(m_ranges, {}));
}

}  // namespace hitscope
