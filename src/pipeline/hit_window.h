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

/// The newest hits of a sequence that uniform arrays hold: so many, with no more different constants than the
/// palette has.
class HitWindow {
public:
    explicit HitWindow(std::size_t capacity) : m_capacity(capacity) {}

    /// Takes the next hit; the oldest, if there is no room for all, go to `dropped`.
    void push(const KeptHit& hit, std::vector<KeptHit>& dropped);
    [[nodiscard]] const std::deque<KeptHit>& hits() const { return m_hits; }

private:
    struct Colour {
        DeformationConstants constants;
        std::size_t hits = 0;
    };
    void dropOldest(std::vector<KeptHit>& dropped);

    std::size_t m_capacity;
    std::deque<KeptHit> m_hits;
    std::vector<Colour> m_palette;
};

}  // namespace hitscope
