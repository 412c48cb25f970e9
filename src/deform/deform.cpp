// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/deform.h"

#include <cmath>

namespace hitscope {

// The order of operations, which shaders/deform.glsl mirrors. Every operation is rounded to float; there are
// no contractions, no library normalize() or length(), and the rim is decided on squares: the function jumps
// by power / max_distance there, so one unit in the last place is a visible step.
//
//   dx = p.x - h.x, dy = p.y - h.y, dz = p.z - h.z
//   r2 = (dx * dx + dy * dy) + dz * dz
//   not (r2 <= max_distance * max_distance): out of reach (a NaN is out of reach, too)
//   r = sqrt(r2)
//   m = r2 == 0 ? max_magnitude : min(power / r, max_magnitude)        eq. 4; at r = 0 the cap applies
//   v = d * m                                                          eq. 3
//   p = p + v                                                          eq. 1
//   s = n + v,  len2 = (s.x * s.x + s.y * s.y) + s.z * s.z             eq. 2
//   len2 > 1e-12: n = s / sqrt(len2); else n stays, since the sum has no direction
bool deform(glm::vec3& position, glm::vec3& normal, const Hit& hit) {
    const float dx = position.x - hit.point.x;
    const float dy = position.y - hit.point.y;
    const float dz = position.z - hit.point.z;
    const float r2 = (dx * dx + dy * dy) + dz * dz;
    if (!(r2 <= hit.constants.maxDistance * hit.constants.maxDistance)) {
        return false;
    }
    const float r = std::sqrt(r2);
    float magnitude = hit.constants.maxMagnitude;
    if (r2 != 0.0f) {
        const float ratio = hit.constants.power / r;
        magnitude = ratio < magnitude ? ratio : magnitude;
    }
    const float vx = hit.direction.x * magnitude;
    const float vy = hit.direction.y * magnitude;
    const float vz = hit.direction.z * magnitude;
    position.x += vx;
    position.y += vy;
    position.z += vz;

    const float sx = normal.x + vx;
    const float sy = normal.y + vy;
    const float sz = normal.z + vz;
    const float len2 = (sx * sx + sy * sy) + sz * sz;
    if (len2 > 1e-12f) {
        const float length = std::sqrt(len2);
        normal.x = sx / length;
        normal.y = sy / length;
        normal.z = sz / length;
    }
    return true;
}

}  // namespace hitscope
