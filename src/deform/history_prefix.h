// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "deform/hit_history.h"

namespace hitscope {

/// The first hits of a history, for who shows it as it was after them: turns edits of the history, and a
/// change of how many are wanted, into edits of these first ones.
class HistoryPrefix {
public:
    [[nodiscard]] std::size_t size() const { return m_size; }
    /// Starts over with the first `size` hits.
    void reset(std::size_t size) { m_size = size; }
    /// `edits` were made of the history since, in this order, and `history` is what they led to, of which the
    /// first `wanted` (<= its size) are to remain.
    [[nodiscard]] std::vector<HistoryEdit> follow(std::span<const HistoryEdit> edits,
                                                  std::span<const Hit> history, std::size_t wanted);

private:
    std::size_t m_size = 0;
};

}  // namespace hitscope
