// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

namespace hitscope {

/// The direction (unit) in which a projectile of `speed` m/s has to leave `from` so that its fall brings it
/// through `to` (metres, world): the flatter of the two arcs; the straight line where no arc reaches that
/// far. from != to.
[[nodiscard]] glm::vec3 launchDirection(const glm::vec3& from, const glm::vec3& to, float speed);

}  // namespace hitscope
