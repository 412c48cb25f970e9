// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame_times.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace hitscope {

FrameTimes::FrameTimes(std::size_t capacity) : m_capacity(std::max<std::size_t>(capacity, 1)) {
    m_samples.reserve(m_capacity);
}

void FrameTimes::add(double end, double cost) {
    if (m_samples.size() < m_capacity) {
        m_samples.push_back({end, cost});
    } else {
        m_samples[m_next] = {end, cost};
        m_next = (m_next + 1) % m_capacity;
    }
}

void FrameTimes::clear() {
    m_samples.clear();
    m_next = 0;
}

std::vector<FrameTimes::Sample> FrameTimes::samples() const {
    std::vector<Sample> ordered(m_samples.size());
    std::rotate_copy(m_samples.begin(), m_samples.begin() + static_cast<std::ptrdiff_t>(m_next),
                     m_samples.end(), ordered.begin());
    return ordered;
}

FrameTimes::Summary FrameTimes::summary(double now) const {
    Summary summary;
    if (m_samples.empty()) {
        return summary;
    }
    std::vector<double> costs;
    std::vector<double> recent;
    costs.reserve(m_samples.size());
    for (const Sample& sample : m_samples) {
        costs.push_back(sample.cost);
        if (sample.end > now - 1.0 && sample.end <= now) {
            recent.push_back(sample.cost);
        }
    }
    const std::size_t newest = m_samples.size() < m_capacity ? m_samples.size() : m_next + m_capacity;
    summary.lastCost = m_samples[(newest - 1) % m_capacity].cost;
    summary.recent = recent.size();
    if (!recent.empty()) {
        const auto middle = recent.begin() + static_cast<std::ptrdiff_t>(recent.size() / 2);
        std::nth_element(recent.begin(), middle, recent.end());
        summary.recentCost = *middle;
        summary.framesPerSecond = summary.recentCost > 0.0 ? 1.0 / summary.recentCost : 0.0;
    }
    std::sort(costs.begin(), costs.end(), std::greater<>());
    const std::size_t count = costs.size();
    summary.meanCost = std::accumulate(costs.begin(), costs.end(), 0.0) / static_cast<double>(count);
    summary.medianCost = count % 2 == 1 ? costs[count / 2] : 0.5 * (costs[count / 2 - 1] + costs[count / 2]);
    summary.percentile99Cost = costs[count / 100];
    summary.worstCost = costs.front();
    const std::size_t slowest = std::max<std::size_t>(1, count / 100);
    const double slowestSum =
        std::accumulate(costs.begin(), costs.begin() + static_cast<std::ptrdiff_t>(slowest), 0.0);
    summary.onePercentLow = slowestSum > 0.0 ? static_cast<double>(slowest) / slowestSum : 0.0;
    return summary;
}

}  // namespace hitscope
