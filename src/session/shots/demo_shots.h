// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "session/session.h"
#include "view/camera.h"

namespace hitscope {

/// `count` shots at the session's visible targets in turn, each aimed at a vertex that faces sideways or up,
/// from a few metres away and within 30 degrees of its normal. The same session, count and seed give the same
/// shots. Empty if no target has a surface.
[[nodiscard]] std::vector<Ray> demoShots(const Session& session, int count, std::uint32_t seed);

/// Shoots them one after the other, 0.1 s apart, and lets the last one land.
void shootAll(Session& session, const std::vector<Ray>& shots);

}  // namespace hitscope
