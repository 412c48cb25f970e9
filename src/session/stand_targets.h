// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/result.h"
#include "session/target_state.h"

namespace hitscope {

class Session;

/// Turns targets together by a quarter about the world's x axis, so that what pointed along z points along y:
/// for meshes of programs in which z is up. Their middle stays above the same place, and the lowest of their
/// vertices, as they are dented, as high as it was; vertices that no face uses do not count. One step to
/// undo. Ids of no target are passed over. Errors: a place would not be finite.
[[nodiscard]] Status turnUpright(Session& session, std::span<const TargetId> ids);

/// Moves each target straight up or down until the lowest of its vertices, as it is dented, is at the height
/// of the floor. One step to undo, none where all are there already. Ids of no target are passed over.
/// Errors: a place would not be finite.
[[nodiscard]] Status setOnFloor(Session& session, std::span<const TargetId> ids);

}  // namespace hitscope
