// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace hitscope {

/// Entries [first, end) of an index buffer.
struct IndexRun {
    std::uint32_t first = 0;
    std::uint32_t end = 0;
};

/// How many entries are in all of them.
[[nodiscard]] inline std::size_t countOf(std::span<const IndexRun> runs) {
    return std::accumulate(runs.begin(), runs.end(), std::size_t{0},
                           [](std::size_t sum, const IndexRun& run) { return sum + (run.end - run.first); });
}

/// What of them, which are in order, is in the range.
[[nodiscard]] inline std::vector<IndexRun> within(std::span<const IndexRun> runs, const IndexRun& range) {
    const auto isBefore = [&range](const IndexRun& run) { return run.end <= range.first; };
    std::vector<IndexRun> parts;
    for (auto run = std::partition_point(runs.begin(), runs.end(), isBefore);
         run != runs.end() && run->first < range.end; ++run) {
        parts.push_back({std::max(run->first, range.first), std::min(run->end, range.end)});
    }
    return parts;
}

/// What is in both.
[[nodiscard]] inline std::vector<IndexRun> within(std::span<const IndexRun> runs,
                                                  std::span<const IndexRun> ranges) {
    std::vector<IndexRun> parts;
    for (const IndexRun& range : ranges) {
        const std::vector<IndexRun> more = within(runs, range);
        parts.insert(parts.end(), more.begin(), more.end());
    }
    return parts;
}

/// Runs of an index buffer (32 bits an index), as glMultiDrawElements() takes them.
struct IndexRuns {
    std::vector<int> counts;          ///< indices
    std::vector<const void*> starts;  ///< the byte of the buffer
    std::size_t indices = 0;          ///< in all of them

    void add(std::size_t first, std::size_t count) {
        counts.push_back(static_cast<int>(count));
        // NOLINTNEXTLINE(performance-no-int-to-ptr): GL's way to say it
        starts.push_back(reinterpret_cast<const void*>(first * sizeof(std::uint32_t)));
        indices += count;
    }
};

}  // namespace hitscope
