// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "deform/hit.h"

namespace hitscope {

/// The ordered hits of a session: the truth that every target's state follows from.
///
/// `revision` grows with every change other than an append; who has applied the first n hits of revision r
/// and finds r unchanged needs only hits [n, size()), anyone else re-applies from the originals.
class HitHistory {
public:
    [[nodiscard]] std::span<const Hit> hits() const { return m_hits; }
    [[nodiscard]] std::size_t size() const { return m_hits.size(); }
    /// The hits on one target, in order.
    [[nodiscard]] std::vector<Hit> hitsOn(TargetId target) const;
    [[nodiscard]] std::uint64_t revision() const { return m_revision; }

    void append(const Hit& hit);                                    ///< `hit` has passed checkedHit()
    void removeLast();                                              ///< size() > 0
    void remove(std::size_t index);                                 ///< index < size()
    void removeTarget(TargetId target);                             ///< every hit on it
    void setConstantsOfAll(const DeformationConstants& constants);  ///< isValid(constants)
    void assign(std::vector<Hit> hits);                             ///< all of them have passed checkedHit()
    void clear();

private:
    std::vector<Hit> m_hits;
    std::uint64_t m_revision = 0;
};

}  // namespace hitscope
