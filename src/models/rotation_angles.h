// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace hitscope {

/// Rotation about x, then y, then z (the world's axes). Degrees.
[[nodiscard]] glm::quat fromAngles(const glm::dvec3& degrees);
/// The angles of a rotation, in [-180, 180]: of the two triples that give it, the one of the smaller sum,
/// regardless of signs. `shown` itself where it already gives this rotation, so that numbers in front of a
/// person do not jump to others that mean the same.
[[nodiscard]] glm::dvec3 toAngles(const glm::quat& rotation, const glm::dvec3& shown);

}  // namespace hitscope
