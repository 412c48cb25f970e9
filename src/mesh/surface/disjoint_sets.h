// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace hitscope {

/// Numbers [0, count) joined into sets, each member either on the same or on the other side as the first of
/// its set (union-find with parity).
class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : m_parent(count), m_isOther(count, 0), m_sets(count) {
        std::iota(m_parent.begin(), m_parent.end(), 0u);
    }

    struct Place {
        std::uint32_t root = 0;
        bool isOther = false;  ///< on the other side than the root
    };
    [[nodiscard]] Place find(std::uint32_t member) {
        std::uint32_t root = member;
        bool isOther = false;
        while (m_parent[root] != root) {
            isOther ^= m_isOther[root] != 0;
            root = m_parent[root];
        }
        // Everything on the way then hangs from the root itself.
        bool rest = isOther;
        while (m_parent[member] != root && member != root) {
            const std::uint32_t next = m_parent[member];
            const bool step = m_isOther[member] != 0;
            m_parent[member] = root;
            m_isOther[member] = rest ? 1 : 0;
            rest ^= step;
            member = next;
        }
        return {root, isOther};
    }

    /// Returns false where the two were joined already, on sides that contradict this.
    bool join(std::uint32_t a, std::uint32_t b, bool areOpposed = false) {
        const Place first = find(a);
        const Place second = find(b);
        const bool opposed = (first.isOther != second.isOther) != areOpposed;
        if (first.root == second.root) {
            return !opposed;
        }
        const auto [low, high] = std::minmax(first.root, second.root);
        m_parent[high] = low;
        m_isOther[high] = opposed ? 1 : 0;
        --m_sets;
        return true;
    }

    [[nodiscard]] std::size_t sets() const { return m_sets; }

private:
    std::vector<std::uint32_t> m_parent;
    std::vector<std::uint8_t> m_isOther;
    std::size_t m_sets;
};

}  // namespace hitscope
