// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/deform.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "deform/deform_all.h"

namespace hitscope {
namespace {

constexpr float kNoMagnitude = 1e-15f;  // metres
/// Where a press' sphere goes over into a cone, and how far its front is there, in radii: 12/13 and 5/13.
constexpr float kPressEdge = 0.9230769f;
constexpr float kPressEdgeFront = 0.3846154f;

float turnedComponent(float s, float length) {
    return std::abs(s) < kNoComponent ? 0.0f : s / length;
}

// The order of operations, which shaders/deform.glsl mirrors, and deform_all.cpp for several vertices at
// once. Every operation is rounded to float; there are no contractions, no library normalize() or length(),
// and the rim is decided on squares: the function jumps by power / max_distance there, so one unit in the
// last place is a visible step.
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

// Into each of its callers: it is what all time goes to.
[[gnu::always_inline]] inline std::optional<Contribution> paperContribution(
    const glm::vec3& position, const glm::vec3& point, const glm::vec3& direction,
    const DeformationConstants& constants) {
    const float dx = position.x - point.x;
    const float dy = position.y - point.y;
    const float dz = position.z - point.z;
    const float r2 = (dx * dx + dy * dy) + dz * dz;
    if (!(r2 <= constants.maxDistance * constants.maxDistance)) {
        return std::nullopt;
    }
    Contribution made;
    made.magnitude = constants.maxMagnitude;
    made.isCapped = true;
    if (r2 >= kNoDistance2) {
        made.distance = std::sqrt(r2);
        const float ratio = constants.power / made.distance;
        made.isCapped = !(ratio < made.magnitude);
        made.magnitude = made.isCapped ? made.magnitude : ratio;
    }
    made.displacement = {direction.x * made.magnitude, direction.y * made.magnitude,
                         direction.z * made.magnitude};
    return made;
}

// The other forms. What they add to the rules above: m below 1e-15 counts as 0, which hides every denormal
// number on the way to it, and a vertex with m = 0 is left as it is.

float smoothMagnitude(const DentShape& dent, Contribution& made) {
    const float r = made.distance;
    float m = dent.magnitude;
    made.isCapped = true;
    if (r > 0.0f) {
        const float ratio = dent.power / r;
        made.isCapped = !(ratio < m);
        m = made.isCapped ? m : ratio;
    }
    const float half = 0.5f * dent.reach;
    if (r > half) {
        const float t = std::min((r - half) / half, 1.0f);
        m = m * (1.0f - (t * t) * (3.0f - (t + t)));
    }
    return m;
}

float curveMagnitude(const DentShape& dent, float u) {
    const float x = u * 7.0f;
    const int i = std::min(static_cast<int>(x), 6);
    const float t = x - static_cast<float>(i);
    const float* node = dent.curve.data() + 2 * static_cast<std::ptrdiff_t>(i);
    const float y0 = node[0];
    const float d0 = node[1];
    const float d1 = node[3];
    const float step = node[2] - y0;
    const float c2 = (3.0f * step - (d0 + d0)) - d1;
    const float c3 = (d0 + d1) - (step + step);
    return dent.magnitude * (y0 + t * (d0 + t * (c2 + t * c3)));
}

/// `q` is from the sphere's centre, r2 its square. The sphere's front goes over into a cone at 12/13 of its
/// radius, where that is still continuous with the same slope (the circle's there is -12/5), so that the wall
/// of a deep dent leans; the shoulder is a parabola between front and surface.
float pressMagnitude(const DentShape& dent, const glm::vec3& q, float r2) {
    const glm::vec3& d = dent.direction;
    const float radius = dent.power;
    const float width = dent.magnitude;
    const float a = (q.x * d.x + q.y * d.y) + q.z * d.z;
    const float lx = q.x - d.x * a;
    const float ly = q.y - d.y * a;
    const float lz = q.z - d.z * a;
    const float b2 = (lx * lx + ly * ly) + lz * lz;
    const float edge = radius * kPressEdge;
    float front = 0.0f;
    if (b2 <= edge * edge) {
        front = std::sqrt(radius * radius - b2);
    } else {
        front = radius * kPressEdgeFront - 2.4f * (std::sqrt(b2) - edge);
    }
    const float g = front - a;
    if (!(g > -width) || !(width > 0.0f)) {
        return 0.0f;
    }
    float m = g;
    if (g < width) {
        const float t = g + width;
        m = (0.5f * t) * (t / (width + width));
    }
    const float whole = radius * 1.25f;
    if (r2 > whole * whole) {
        const float t = std::min((std::sqrt(r2) - whole) / (dent.reach - whole), 1.0f);
        m = m * (1.0f - (t * t) * (3.0f - (t + t)));
    }
    return m;
}

float magnitudeOf(const DentShape& dent, const glm::vec3& q, float r2, Contribution& made) {
    made.distance = r2 >= kNoDistance2 ? std::sqrt(r2) : 0.0f;
    switch (dent.kind) {
        case DentKind::Smooth:
            return smoothMagnitude(dent, made);
        case DentKind::Wendland: {
            const float u = std::min(made.distance / dent.reach, 1.0f);
            const float k = 1.0f - u;
            return dent.magnitude * (((k * k) * (k * k)) * (4.0f * u + 1.0f));
        }
        case DentKind::Linear:
            return dent.magnitude * (1.0f - std::min(made.distance / dent.reach, 1.0f));
        case DentKind::Crater: {
            const float s = r2 >= kNoDistance2 ? std::min(r2 / (dent.reach * dent.reach), 1.0f) : 0.0f;
            const float k = 1.0f - s;
            return dent.magnitude * ((k * k) * (1.0f - 4.0f * s));
        }
        case DentKind::Curve:
            return curveMagnitude(dent, std::min(made.distance / dent.reach, 1.0f));
        default:
            return pressMagnitude(dent, q, r2);
    }
}

/// Moves the position and turns the normal.
[[gnu::always_inline]] inline void push(glm::vec3& position, glm::vec3& normal, const glm::vec3& v) {
    position.x += v.x;
    position.y += v.y;
    position.z += v.z;

    const float sx = normal.x + v.x;
    const float sy = normal.y + v.y;
    const float sz = normal.z + v.z;
    const float len2 = (sx * sx + sy * sy) + sz * sz;
    if (len2 > kNoLength2) {
        const float length = std::sqrt(len2);
        normal.x = turnedComponent(sx, length);
        normal.y = turnedComponent(sy, length);
        normal.z = turnedComponent(sz, length);
    }
}

}  // namespace

std::optional<Contribution> contributionTo(const glm::vec3& position, const DentShape& dent) {
    if (dent.kind == DentKind::Paper) {
        return paperContribution(position, dent.point, dent.direction,
                                 {dent.reach, dent.power, dent.magnitude});
    }
    const glm::vec3 q(position.x - dent.point.x, position.y - dent.point.y, position.z - dent.point.z);
    const float r2 = (q.x * q.x + q.y * q.y) + q.z * q.z;
    if (!(r2 <= dent.reach * dent.reach)) {
        return std::nullopt;
    }
    Contribution made;
    made.magnitude = magnitudeOf(dent, q, r2, made);
    if (!(std::abs(made.magnitude) >= kNoMagnitude)) {
        return std::nullopt;
    }
    made.displacement = {dent.direction.x * made.magnitude, dent.direction.y * made.magnitude,
                         dent.direction.z * made.magnitude};
    return made;
}

std::optional<Contribution> contributionTo(const glm::vec3& position, const Hit& hit) {
    if (hit.form.isPaper()) {
        return paperContribution(position, hit.point, hit.direction, hit.constants);
    }
    std::optional<Contribution> made = contributionTo(position, dentShapeOf(hit));
    if (made && hit.form.presses()) {  // the sphere's centre is not the hit's point
        made->distance = glm::distance(position, hit.point);
    }
    return made;
}

bool deform(glm::vec3& position, glm::vec3& normal, const DentShape& dent) {
    const std::optional<Contribution> made = dent.kind == DentKind::Paper
                                                 ? paperContribution(position, dent.point, dent.direction,
                                                                     {dent.reach, dent.power, dent.magnitude})
                                                 : contributionTo(position, dent);
    if (made) {
        push(position, normal, made->displacement);
    }
    return made.has_value();
}

bool deform(glm::vec3& position, glm::vec3& normal, const Hit& hit) {
    if (!hit.form.isPaper()) {
        return deform(position, normal, dentShapeOf(hit));
    }
    const std::optional<Contribution> made =
        paperContribution(position, hit.point, hit.direction, hit.constants);
    if (made) {
        push(position, normal, made->displacement);
    }
    return made.has_value();
}

float magnitudeOnPlane(const DentForm& form, const DeformationConstants& constants, float distance) {
    Hit hit;
    hit.constants = constants;
    hit.form = form;
    const std::optional<Contribution> made = contributionTo({distance, 0.0f, 0.0f}, hit);
    return made ? made->magnitude : 0.0f;
}

}  // namespace hitscope
