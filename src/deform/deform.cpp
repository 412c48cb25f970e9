// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/deform.h"

#include <cmath>

namespace hitscope {
namespace {

/// Nearer than 1e-11 m counts as r = 0. Some renderers flush denormal numbers to zero; from here on that
/// changes nothing: a sum of two squares that feels a lost denormal is below 1e-30, less than half a unit in
/// the last place of r2.
constexpr float kNoDistance2 = 1e-22f;
/// Smaller components of a turned normal count as 0, so that neither they nor the residuals by which
/// exactDivide() in deform.glsl corrects a quotient are denormal.
constexpr float kNoComponent = 1e-20f;

float turnedComponent(float s, float length) {
    return std::abs(s) < kNoComponent ? 0.0f : s / length;
}

}  // namespace

// The order of operations, which shaders/deform.glsl mirrors. Every operation is rounded to float; there are
// no contractions, no library normalize() or length(), and the rim is decided on squares: the function jumps
// by power / max_distance there, so one unit in the last place is a visible step.
//
//   dx = p.x - h.x, dy = p.y - h.y, dz = p.z - h.z
//   r2 = (dx * dx + dy * dy) + dz * dz
//   not (r2 <= max_distance * max_distance): out of reach (a NaN is out of reach, too)
//   r = sqrt(r2)
//   m = r2 < 1e-22 ? max_magnitude : min(power / r, max_magnitude)     eq. 4; at r = 0 the cap applies
//   v = d * m                                                          eq. 3
//   p = p + v                                                          eq. 1
//   s = n + v,  len2 = (s.x * s.x + s.y * s.y) + s.z * s.z             eq. 2
//   len2 > 1e-12: n = s / sqrt(len2), components of s below 1e-20 as 0; else n stays, since the sum has no
//   direction
std::optional<Contribution> contributionTo(const glm::vec3& position, const Hit& hit) {
    const float dx = position.x - hit.point.x;
    const float dy = position.y - hit.point.y;
    const float dz = position.z - hit.point.z;
    const float r2 = (dx * dx + dy * dy) + dz * dz;
    if (!(r2 <= hit.constants.maxDistance * hit.constants.maxDistance)) {
        return std::nullopt;
    }
    Contribution made;
    made.magnitude = hit.constants.maxMagnitude;
    made.isCapped = true;
    if (r2 >= kNoDistance2) {
        made.distance = std::sqrt(r2);
        const float ratio = hit.constants.power / made.distance;
        made.isCapped = !(ratio < made.magnitude);
        made.magnitude = made.isCapped ? made.magnitude : ratio;
    }
    made.displacement = {hit.direction.x * made.magnitude, hit.direction.y * made.magnitude,
                         hit.direction.z * made.magnitude};
    return made;
}

bool deform(glm::vec3& position, glm::vec3& normal, const Hit& hit) {
    const std::optional<Contribution> made = contributionTo(position, hit);
    if (!made) {
        return false;
    }
    const float vx = made->displacement.x;
    const float vy = made->displacement.y;
    const float vz = made->displacement.z;
    position.x += vx;
    position.y += vy;
    position.z += vz;

    const float sx = normal.x + vx;
    const float sy = normal.y + vy;
    const float sz = normal.z + vz;
    const float len2 = (sx * sx + sy * sy) + sz * sz;
    if (len2 > 1e-12f) {
        const float length = std::sqrt(len2);
        normal.x = turnedComponent(sx, length);
        normal.y = turnedComponent(sy, length);
        normal.z = turnedComponent(sz, length);
    }
    return true;
}

}  // namespace hitscope
