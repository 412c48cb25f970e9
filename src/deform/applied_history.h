// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "deform/hit_history.h"

namespace hitscope {

/// Which hits of a history are applied to what is shown, of those that are enabled. A view: `dropped` belongs
/// to someone else.
struct AppliedHits {
    static constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

    std::size_t shown = kAll;              ///< the first ones; more than there are: all
    std::span<const std::size_t> dropped;  ///< indices that the pipeline has no room for, ascending

    [[nodiscard]] bool contains(std::size_t index) const;
};

/// A history as what is shown has it: the same hits in the same rows, of which those that are not applied are
/// disabled. Turns edits of the history, and a change of which hits are applied, into edits of that.
class AppliedHistory {
public:
    /// Starts over: all of it as one edit of an empty history.
    [[nodiscard]] HistoryEdit startOver(std::span<const Hit> history, const AppliedHits& wanted);
    /// `edits` were made of the history since, in this order, and `history` is what they led to, of which
    /// `wanted` is applied. Costs what changes.
    [[nodiscard]] std::vector<HistoryEdit> follow(std::span<const HistoryEdit> edits,
                                                  std::span<const Hit> history, const AppliedHits& wanted);

private:
    [[nodiscard]] AppliedHits applied() const { return {m_shown, m_dropped}; }
    HistoryEdit follow(const HistoryEdit& edit);
    [[nodiscard]] std::vector<std::size_t> rowsToChange(std::size_t size, const AppliedHits& wanted) const;

    std::size_t m_shown = AppliedHits::kAll;
    std::vector<std::size_t> m_dropped;
};

}  // namespace hitscope
