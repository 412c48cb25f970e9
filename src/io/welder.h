// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "core/page_vector.h"

namespace hitscope {

/// Gives equal positions one index, in the order of their first appearance: for formats that do not share
/// vertices between faces. Equal means equal in every coordinate; -0 is 0.
/// `Positions`: a vector of glm::vec3.
template <class Positions = PageVector<glm::vec3>>
class Welder {
public:
    explicit Welder(Positions& positions) : m_positions(positions), m_slots(kFirstSlots, kFree) {}

    std::uint32_t index(glm::vec3 position) {
        position += 0.0f;  // makes -0 into 0
        if (2 * (m_positions.size() - m_first) >= m_slots.size()) {
            grow();
        }
        std::uint32_t& slot = m_slots[find(position)];
        if (slot == kFree) {
            slot = static_cast<std::uint32_t>(m_positions.size());
            m_positions.push_back(position);
        }
        return slot;
    }
    /// Positions so far are not shared with later ones.
    void startAnew() {
        m_first = m_positions.size();
        m_slots.assign(kFirstSlots, kFree);
    }

private:
    static constexpr std::uint32_t kFree = 0xffffffffu;
    static constexpr std::size_t kFirstSlots = 1024;

    [[nodiscard]] std::size_t find(const glm::vec3& position) const {
        const std::size_t mask = m_slots.size() - 1;
        std::size_t at = hash(position) & mask;
        while (m_slots[at] != kFree && m_positions[m_slots[at]] != position) {
            at = (at + 1) & mask;
        }
        return at;
    }
    static std::size_t hash(const glm::vec3& position) {
        std::uint64_t h = 0;
        for (int i = 0; i < 3; ++i) {
            h = (h ^ std::bit_cast<std::uint32_t>(position[i])) * 0x9e3779b97f4a7c15ull;
            h ^= h >> 29;
        }
        return static_cast<std::size_t>(h);
    }
    void grow() {
        m_slots.assign(2 * m_slots.size(), kFree);
        for (std::size_t v = m_first; v < m_positions.size(); ++v) {
            m_slots[find(m_positions[v])] = static_cast<std::uint32_t>(v);
        }
    }

    Positions& m_positions;
    std::vector<std::uint32_t> m_slots;  ///< open addressing; a power of two
    std::size_t m_first = 0;
};

}  // namespace hitscope
