// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/session.h"

namespace hitscope {

/// The target that statistics and export are about: the selected one; with none selected, the one hit last;
/// with no hits, the first. Null only in an empty scene.
[[nodiscard]] const Target* focusTarget(const Session& session);

}  // namespace hitscope
