// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/run_positions.h"

#include <algorithm>

namespace hitscope::physics {

RunPositions::RunPositions(std::span<const glm::vec3> original) : m_original(original) {
    m_runs.reserve((original.size() + kRun - 1) / kRun);
    for (std::size_t first = 0; first < original.size(); first += kRun) {
        m_runs.push_back(original.data() + first);
    }
}

std::span<glm::vec3> RunPositions::change(std::uint32_t run) {
    const std::size_t count = sizeOf(run);
    const glm::vec3* const original = m_original.data() + run * kRun;
    if (m_runs[run] != original) {
        return {const_cast<glm::vec3*>(m_runs[run]), count};
    }
    const std::size_t place = m_changed.size();
    if (place / kRunsAtOnce == m_own.size()) {
        m_own.emplace_back(new glm::vec3[kRunsAtOnce * kRun]);
    }
    glm::vec3* const own = m_own[place / kRunsAtOnce].get() + place % kRunsAtOnce * kRun;
    std::copy_n(original, count, own);
    m_runs[run] = own;
    m_changed.push_back(run);
    return {own, count};
}

void RunPositions::reset() {
    for (const std::uint32_t run : m_changed) {
        m_runs[run] = m_original.data() + run * kRun;
    }
    m_changed.clear();
    m_own.clear();
}

}  // namespace hitscope::physics
