// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "session/session_undo.h"

namespace hitscope {

/// What a step of the history is called behind "Undo" and "Redo" in a menu: "Hit", "Remove 3 Hits".
[[nodiscard]] QString undoText(const SessionUndo::Name& name);

}  // namespace hitscope
