// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace hitscope {

/// How far the opening of files is over all of them. Reading a file tells its share; preparing its mesh
/// cannot, and usually takes some times as long as the reading took.
class OpeningProgress {
public:
    /// One a file: bytes, or anything that what it takes goes with.
    explicit OpeningProgress(std::vector<double> sizes) : m_sizes(std::move(sizes)) {}

    /// The share of all, [0, 1], where `share` of a file is read.
    [[nodiscard]] double reading(std::size_t file, double share) const { return of(file, kReading * share); }
    /// Likewise where it was read in so many seconds and its mesh is being prepared for so many.
    [[nodiscard]] double preparing(std::size_t file, double read, double prepared) const {
        constexpr double kSure = 0.9;  // what comes after it may take ever so long
        const double expected = read * (1.0 - kReading) / kReading;
        const double share = expected > 0.0 ? prepared / expected : 1.0;
        const double rest = 1.0 - kSure;
        const double slowed = share < kSure ? share : kSure + rest * (1.0 - std::exp((kSure - share) / rest));
        return of(file, kReading + (1.0 - kReading) * slowed);
    }

private:
    static constexpr double kReading = 0.28;  ///< of both: 2,000,000 quads of OBJ, 1.2 of 4.2 s

    [[nodiscard]] double of(std::size_t file, double share) const {
        const auto begin = m_sizes.begin();
        const auto at = begin + static_cast<std::ptrdiff_t>(file);
        const double all = std::accumulate(begin, m_sizes.end(), 0.0);
        return all > 0.0 ? (std::accumulate(begin, at, 0.0) + share * *at) / all : share;
    }

    std::vector<double> m_sizes;
};

}  // namespace hitscope
