// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/rotation_angles.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

namespace hitscope {

namespace {

constexpr double kSameRotation =
    1.0e-6;  // between unit quaternions of one rotation, one of them rounded to float
constexpr double kGimbalLock = 0.9999999;  // sine of y beyond which x and z turn about the same axis

bool isSame(const glm::dquat& a, const glm::dquat& b) {
    return std::min(glm::length(a - b), glm::length(a + b)) < kSameRotation;
}

glm::dquat turn(const glm::dvec3& degrees) {
    const glm::dvec3 r = glm::radians(degrees);
    return glm::angleAxis(r.z, glm::dvec3(0, 0, 1)) * glm::angleAxis(r.y, glm::dvec3(0, 1, 0)) *
           glm::angleAxis(r.x, glm::dvec3(1, 0, 0));
}

}  // namespace

glm::quat fromAngles(const glm::dvec3& degrees) {
    return glm::quat(turn(degrees));
}

glm::dvec3 toAngles(const glm::quat& rotation, const glm::dvec3& shown) {
    const glm::dquat q(rotation);
    if (isSame(q, turn(shown))) {
        return shown;
    }
    const double sine = std::clamp(2.0 * (q.w * q.y - q.z * q.x), -1.0, 1.0);
    glm::dvec3 angles;
    angles.y = std::asin(sine);
    if (std::abs(sine) > kGimbalLock) {
        angles.x = 0.0;
        // Only the difference (or sum) of x and z counts; all of it is given to z.
        angles.z = std::atan2(2.0 * (q.w * q.z - q.x * q.y), 1.0 - 2.0 * (q.x * q.x + q.z * q.z));
    } else {
        angles.x = std::atan2(2.0 * (q.w * q.x + q.y * q.z), 1.0 - 2.0 * (q.x * q.x + q.y * q.y));
        angles.z = std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
    }
    return glm::degrees(angles);
}

}  // namespace hitscope
