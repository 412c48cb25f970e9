// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "session/session_undo.h"

namespace hitscope {

/// What a step of the history is called behind "Undo" and "Redo" in a menu: "Hit", "Remove 3 Hits".
[[nodiscard]] QString undoText(const SessionUndo::Name& name);
/// Likewise in a list of the steps, with the target that it is about: "Move Target “Teapot”".
[[nodiscard]] QString undoText(const SessionUndo& steps, std::size_t step);

}  // namespace hitscope
