// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "view/camera.h"

namespace hitscope {

/// The direction (unit) in which a projectile of `speed` m/s has to leave `from` so that its fall, by
/// `gravity` m/s^2 downwards, brings it through `to` (metres, world): the flatter of the two arcs; the
/// straight line where no arc reaches that far. from != to.
[[nodiscard]] glm::vec3 launchDirection(const glm::vec3& from, const glm::vec3& to, float speed,
                                        float gravity);

/// Where a shot along a ray of that camera's picture starts: at the eye. An orthographic ray starts outside
/// the scene, so there it is as far from what it meets (metres, world) as the eye is from the pivot, or, if
/// it meets nothing, beside the eye.
[[nodiscard]] Ray shotAlong(const Ray& ray, const Camera& camera, const std::optional<glm::vec3>& met);

}  // namespace hitscope
