// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <unordered_map>
#include <vector>

#include "deform/hit_history.h"

namespace hitscope {

/// A change of the enabled hits on one target: those at [first, first + before.size()) became `after`.
struct TargetHitsEdit {
    TargetId target;
    std::size_t first = 0;
    std::vector<Hit> before;
    std::vector<Hit> after;
};

/// The enabled hits of a history, sorted by target. Targets do not influence one another, so this is how
/// whoever deforms meshes sees a history: without groups.
class HitsByTarget {
public:
    /// Follows an edit of the history. Returns what it changes, each target once; nothing where it changes
    /// nothing.
    std::vector<TargetHitsEdit> apply(const HistoryEdit& edit);
    /// Starts over with these hits.
    void reset(std::span<const Hit> history);

    [[nodiscard]] std::span<const Hit> of(TargetId target) const;

    /// Where a hit of the history went: among those of `target`, unless it is disabled.
    struct Place {
        TargetId target;
        bool enabled = true;
    };
    [[nodiscard]] std::span<const Place> places() const { return m_places; }  ///< one a hit of the history

private:
    [[nodiscard]] std::size_t enabledBefore(std::size_t index, TargetId target) const;

    std::vector<Place> m_places;
    std::unordered_map<TargetId, std::vector<Hit>> m_hits;
};

}  // namespace hitscope
