// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/vertex_range.h"

#include <algorithm>
#include <utility>

namespace hitscope {

namespace {
constexpr std::size_t kLeastMerge = 256;
}

std::vector<VertexRange> merged(std::vector<VertexRange> ranges) {
    std::erase_if(ranges, [](const VertexRange& range) { return range.count == 0; });
    std::sort(ranges.begin(), ranges.end(),
              [](const VertexRange& a, const VertexRange& b) { return a.first < b.first; });
    std::size_t kept = 0;
    for (const VertexRange& range : ranges) {
        if (kept > 0 && range.first <= ranges[kept - 1].first + ranges[kept - 1].count) {
            VertexRange& last = ranges[kept - 1];
            last.count = std::max(last.first + last.count, range.first + range.count) - last.first;
        } else {
            ranges[kept++] = range;
        }
    }
    ranges.resize(kept);
    return ranges;
}

std::size_t vertexCount(std::span<const VertexRange> ranges) {
    std::size_t count = 0;
    for (const VertexRange& range : ranges) {
        count += range.count;
    }
    return count;
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

std::vector<VertexRange> ChangedRanges::take(std::size_t most) {
    std::vector<VertexRange> taken = take();
    std::size_t vertices = 0;
    for (std::size_t i = 0; i < taken.size(); ++i) {
        vertices += taken[i].count;
        if (vertices > most) {
            std::vector<VertexRange> left(taken.begin() + static_cast<std::ptrdiff_t>(i), taken.end());
            const auto fitting = static_cast<std::uint32_t>(taken[i].count - (vertices - most));
            taken.resize(i);
            if (fitting > 0) {
                taken.push_back({left.front().first, fitting});
                left.front().first += fitting;
                left.front().count -= fitting;
            }
            add(left);
            break;
        }
    }
    return taken;
}

}  // namespace hitscope
