// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "deform/hit.h"

namespace hitscope {

/// A hit of the history as a pipeline of limited capacity keeps it.
struct KeptHit {
    std::size_t index = 0;     ///< in the history
    std::uint64_t serial = 0;  ///< grows in the order in which hits became known
    Hit hit;
};

/// The newest hits of a sequence, as many as uniform arrays hold.
class HitWindow {
public:
    explicit HitWindow(std::size_t capacity) : m_capacity(capacity) {}

    /// Takes the next hit; the oldest, if there is no room for all, goes to `dropped`.
    void push(const KeptHit& hit, std::vector<KeptHit>& dropped);
    [[nodiscard]] const std::deque<KeptHit>& hits() const { return m_hits; }

private:
    std::size_t m_capacity;
    std::deque<KeptHit> m_hits;
};

}  // namespace hitscope
