// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/session_undo.h"

namespace hitscope {

/// Whether the steps that can be undone have changed targets of the scene that is open: added or removed,
/// moved, named, or changed in their meshes or physics. It is work that a person would miss, as hits are;
/// what is shown and the settings are not.
[[nodiscard]] bool hasWorkOnTargets(const SessionUndo& steps);

}  // namespace hitscope
