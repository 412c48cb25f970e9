// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <LinearMath/btTransform.h>

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace hitscope::physics {

/// Coordinates further out than this, metres, are not simulated: there a float is a metre coarse.
inline constexpr float kFarthest = 1.0e7f;

inline btVector3 toBullet(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}
inline btQuaternion toBullet(const glm::quat& q) {
    return {q.x, q.y, q.z, q.w};
}
inline glm::vec3 fromBullet(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}
inline glm::quat fromBullet(const btQuaternion& q) {
    return {q.w(), q.x(), q.y(), q.z()};
}

/// Finite and near enough to be simulated.
inline bool isUsable(const glm::vec3& v) {
    // Written so that NaN fails.
    return std::abs(v.x) <= kFarthest && std::abs(v.y) <= kFarthest && std::abs(v.z) <= kFarthest;
}

}  // namespace hitscope::physics
