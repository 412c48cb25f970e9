// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace hitscope {

/// Rotation about x, then y, then z (the world's axes). Degrees.
[[nodiscard]] glm::quat fromAngles(const glm::dvec3& degrees);
/// The angles of a rotation: x and z in (-180, 180], y in [-90, 90]. `shown` itself where it already gives
/// this rotation, so that numbers in front of a person do not jump to others that mean the same.
[[nodiscard]] glm::dvec3 toAngles(const glm::quat& rotation, const glm::dvec3& shown);

}  // namespace hitscope
