// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/shots/shot_schedule.h"

#include <algorithm>
#include <utility>

namespace hitscope {

namespace {

constexpr double kRounding = 1.0e-6;  // of a step: times that are sums of steps are due at that step

}  // namespace

void ShotSchedule::add(std::span<const ScheduledShot> shots, double now, int series) {
    std::vector<Waiting> added;
    added.reserve(shots.size());
    for (const ScheduledShot& shot : shots) {
        added.push_back({{shot, 0, series}, now + std::max(0.0, shot.delay)});
    }
    const auto isEarlier = [](const Waiting& a, const Waiting& b) { return a.time < b.time; };
    std::stable_sort(added.begin(), added.end(), isEarlier);
    for (std::size_t i = 1; i < added.size(); ++i) {
        if (added[i].time == added[i - 1].time) {
            int& volley = added[i - 1].due.volley;
            volley = volley != 0 ? volley : ++m_lastVolley;
            added[i].due.volley = volley;
        }
    }
    m_waiting.insert(m_waiting.end(), added.begin(), added.end());
    std::stable_sort(m_waiting.begin(), m_waiting.end(), isEarlier);
}

bool ShotSchedule::isDue(double now, double step) const {
    return !m_waiting.empty() && m_waiting.front().time <= now + kRounding * step;
}

std::size_t ShotSchedule::countDue(double now, double step) const {
    const auto later =
        std::upper_bound(m_waiting.begin(), m_waiting.end(), now + kRounding * step,
                         [](double time, const Waiting& waiting) { return time < waiting.time; });
    return static_cast<std::size_t>(later - m_waiting.begin());
}

ShotSchedule::Due ShotSchedule::takeNext() {
    Due next = std::move(m_waiting.front().due);
    m_waiting.pop_front();
    return next;
}

}  // namespace hitscope
