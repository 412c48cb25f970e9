// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "session/session.h"

namespace hitscope {

/// What the status bar says of the shots of a click or a series: that they are on their way, or what they
/// struck. Nothing between the two for a series.
[[nodiscard]] QString shotText(const ShotCount& count, const Session& session);

/// Of hits on `target` that moved no vertex, such as this one: why not.
[[nodiscard]] QString idleHitText(const Hit& hit, const Target& target);

}  // namespace hitscope
