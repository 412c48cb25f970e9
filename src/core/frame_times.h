// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace hitscope {

/// The last frames' times and what they amount to.
class FrameTimes {
public:
    explicit FrameTimes(std::size_t capacity = 1024);

    /// A frame that ended at `end` seconds (any clock that does not go back) and took `cost` seconds to make.
    void add(double end, double cost);
    void clear();

    struct Sample {
        double end = 0.0;   ///< seconds
        double cost = 0.0;  ///< seconds
    };
    [[nodiscard]] std::vector<Sample> samples() const;  ///< oldest first
    [[nodiscard]] std::size_t size() const { return m_samples.size(); }

    struct Summary {
        std::size_t recent = 0;         ///< frames that ended in the last second before `now`; 0: idle
        double recentCost = 0.0;        ///< seconds, the median of those
        double framesPerSecond = 0.0;   ///< as many as frames that cost that allow; 0: idle
        double lastCost = 0.0;          ///< seconds, of the last frame
        double meanCost = 0.0;          ///< seconds, over the samples kept
        double medianCost = 0.0;        ///< seconds
        double percentile99Cost = 0.0;  ///< seconds; 99 of 100 frames took that long or less (nearest rank)
        double worstCost = 0.0;         ///< seconds
        double onePercentLow =
            0.0;  ///< frames a second, 1 / mean cost of the slowest hundredth (at least one frame)
    };
    [[nodiscard]] Summary summary(double now) const;

private:
    std::size_t m_capacity;
    std::size_t m_next = 0;  ///< where the next one goes once full
    std::vector<Sample> m_samples;
};

}  // namespace hitscope
