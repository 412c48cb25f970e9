// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "deform/hit_history.h"

namespace hitscope {

/// True when the edit leaves every hit where it was: it changes one hit, or of several only what a person
/// edits, as their constants, their direction or their point, and their target, where that got another mesh.
[[nodiscard]] bool keepsPlaces(const HistoryEdit& edit);

/// Where each hit of a history went in a number of edits, so that a selection can follow. A hit that one edit
/// takes out and a later one puts back in has moved; equal hits are not told apart, but keep their order.
class HitRows {
public:
    /// `sizeBefore` hits before the first of `edits`, which are in the order made.
    HitRows(std::size_t sizeBefore, std::span<const HistoryEdit> edits);

    /// Where the hit that was at `before` (< the size before) is now; nothing: it is gone.
    [[nodiscard]] std::optional<std::size_t> now(std::size_t before) const;
    [[nodiscard]] std::size_t size() const { return m_size; }  ///< hits after the edits

private:
    std::vector<std::uint32_t> m_now;  ///< by row before
    std::size_t m_size = 0;
};

}  // namespace hitscope
