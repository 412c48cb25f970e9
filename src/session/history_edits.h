// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "deform/hit_history.h"

namespace hitscope {

/// Hits that came one by one are applied in one pass all the same.
[[nodiscard]] std::vector<HistoryEdit> withAppendsJoined(std::vector<HistoryEdit> edits);

/// What was done in place (other constants, hits disabled) and undone at once leaves nothing to do. Hits that
/// went and came back are kept: their target may have gone and come back with them, as another.
[[nodiscard]] std::vector<HistoryEdit> withoutUndone(std::vector<HistoryEdit> edits);

/// Whether the edit, the last of those that led to `hits` hits, put hits at their end.
[[nodiscard]] bool isAppend(const HistoryEdit& edit, std::size_t hits);

}  // namespace hitscope
