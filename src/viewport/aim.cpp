// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/aim.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace hitscope {

namespace {

// Aside, of the way: nothing to allow for when shooting straight up or down.
constexpr double kSteep = 1.0e-5;

}  // namespace

glm::vec3 launchDirection(const glm::vec3& from, const glm::vec3& to, float speed, float gravity) {
    const glm::vec3 straight = to - from;
    const double aside = std::hypot(static_cast<double>(straight.x), static_cast<double>(straight.z));
    const double up = static_cast<double>(straight.y);
    const double v2 = static_cast<double>(speed) * static_cast<double>(speed);
    const double g = gravity;
    // y = x tan(a) - g x^2 / (2 v^2 cos(a)^2), solved for tan(a).
    const double discriminant = v2 * v2 - g * (g * aside * aside + 2.0 * up * v2);
    if (!(aside > kSteep * std::abs(up)) || !(v2 > 0.0) || discriminant < 0.0) {
        return glm::normalize(straight);
    }
    // The flatter one, written so that no digits cancel, and that no gravity is no exception.
    const double slope = (g * aside * aside + 2.0 * up * v2) / (aside * (v2 + std::sqrt(discriminant)));
    return glm::normalize(glm::vec3(straight.x, static_cast<float>(slope * aside), straight.z));
}

Ray shotAlong(const Ray& ray, const Camera& camera, const std::optional<glm::vec3>& met) {
    if (!camera.isOrthographic()) {
        return ray;
    }
    const glm::vec3 towards = met.value_or(camera.eye()) - ray.origin;
    const float before = met ? camera.distance() : 0.0f;
    const float along = std::max(glm::dot(towards, ray.direction) - before, 0.0f);
    return {ray.origin + along * ray.direction, ray.direction};
}

}  // namespace hitscope
