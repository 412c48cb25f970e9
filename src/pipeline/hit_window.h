// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <map>
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
    /// Room for so many hits and so many different curves of theirs.
    HitWindow(std::size_t capacity, std::size_t curves) : m_capacity(capacity), m_mostCurves(curves) {}

    /// Takes the next hit; the oldest, if there is no room for all, go to `dropped`.
    void push(const KeptHit& hit, std::vector<KeptHit>& dropped);
    [[nodiscard]] const std::deque<KeptHit>& hits() const { return m_hits; }

private:
    void dropOldest(std::vector<KeptHit>& dropped);

    std::size_t m_capacity;
    std::size_t m_mostCurves;
    std::map<CurveOrdinates, std::size_t> m_curves;  ///< and how many hits have it
    std::deque<KeptHit> m_hits;
};

}  // namespace hitscope
