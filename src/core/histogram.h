// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hitscope {

/// How many values fall into each of equally wide bins over [low, high]; the last bin includes `high`.
struct Histogram {
    double low = 0.0;
    double high = 0.0;                  ///< > low, unless there is nothing to show
    std::vector<std::uint32_t> counts;  ///< one a bin; empty: nothing to show

    Histogram() = default;
    /// Empty bins. low < high, bins > 0.
    Histogram(double from, double to, std::size_t bins) : low(from), high(to), counts(bins, 0) {}

    [[nodiscard]] double binWidth() const {
        return counts.empty() ? 0.0 : (high - low) / static_cast<double>(counts.size());
    }
    /// Values outside [low, high] are passed over, and so is what is not a number.
    void add(double value) {
        if (!(value >= low && value <= high) || counts.empty()) {
            return;
        }
        const auto bin = static_cast<std::size_t>((value - low) / binWidth());
        ++counts[bin < counts.size() ? bin : counts.size() - 1];
    }
    bool operator==(const Histogram&) const = default;
};

}  // namespace hitscope
