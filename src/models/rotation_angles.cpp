// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/rotation_angles.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

namespace hitscope {

namespace {

constexpr double kSameRotation =
    1.0e-6;                       // between unit quaternions of one rotation, one of them rounded to float
constexpr double kLess = 1.0e-3;  // degrees
constexpr double kGimbalLock = 0.9999999;  // sine of y beyond which x and z turn about the same axis

bool isSame(const glm::dquat& a, const glm::dquat& b) {
    return std::min(glm::length(a - b), glm::length(a + b)) < kSameRotation;
}

double halfTurnFrom(double degrees) {
    return degrees > 0.0 ? degrees - 180.0 : degrees + 180.0;
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
    // Two triples give each rotation: the one that turns less in all reads as what was done.
    const glm::dvec3 first = glm::degrees(angles);
    const glm::dvec3 second(halfTurnFrom(first.x), (first.y < 0.0 ? -180.0 : 180.0) - first.y,
                            halfTurnFrom(first.z));
    const auto sum = [](const glm::dvec3& a) { return std::abs(a.x) + std::abs(a.y) + std::abs(a.z); };
    return sum(second) < sum(first) - kLess ? second : first;
}

}  // namespace hitscope
