// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "session/session_undo.h"

namespace hitscope {

/// Tells the last of the steps that can be undone that has changed targets of the scene that is open: added
/// or removed, moved, named, or changed in their meshes or physics. It is SessionUndo::state() after it; 0:
/// there is none. Such steps are work that a person would miss, as hits are; what is shown and the settings
/// are not.
[[nodiscard]] std::uint64_t workOnTargets(const SessionUndo& steps);
[[nodiscard]] inline bool hasWorkOnTargets(const SessionUndo& steps) {
    return workOnTargets(steps) != 0;
}

}  // namespace hitscope
