// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/dent_shape.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace hitscope {

namespace {

constexpr float kReachInRadii = 2.0f;     // of a press
constexpr float kShoulder = 0.125f;       // of the radius, at most
constexpr float kShoulderOfDepth = 0.5f;  // at most, so that the middle is as deep as was asked for

/// Of unit length in float, with no components so small that they would give denormal numbers; zero: not
/// known.
glm::vec3 unitNormal(const Hit& hit) {
    constexpr float kSmallestComponent = 1e-20f;
    const glm::dvec3 whole(hit.normal);
    const double lengthSquared = glm::dot(whole, whole);
    if (lengthSquared == 0.0) {
        return glm::vec3(0.0f);
    }
    glm::vec3 unit =
        std::abs(lengthSquared - 1.0) > 2.5e-7 ? glm::vec3(whole / std::sqrt(lengthSquared)) : hit.normal;
    for (glm::length_t i = 0; i < 3; ++i) {
        unit[i] = std::abs(unit[i]) < kSmallestComponent ? 0.0f : unit[i];
    }
    return unit;
}

/// A sphere that touches the surface at the hit's point from outside goes on along the direction by the
/// depth: max_magnitude, and no more than half of it gets in.
DentShape pressOf(const Hit& hit) {
    const glm::vec3& d = hit.direction;
    const float radius = hit.form.radius;
    const float depth = std::min(hit.constants.maxMagnitude, radius);
    glm::vec3 n = unitNormal(hit);
    if (!((n.x * d.x + n.y * d.y) + n.z * d.z < 0.0f)) {  // not known, or turned away by an edit
        n = {-d.x, -d.y, -d.z};
    }
    DentShape shape;
    shape.kind = DentKind::Press;
    shape.direction = d;
    for (glm::length_t i = 0; i < 3; ++i) {
        shape.point[i] = (hit.point[i] + n[i] * radius) + d[i] * depth;
    }
    shape.reach = kReachInRadii * radius;
    shape.power = radius;
    shape.magnitude = std::min(kShoulder * radius, kShoulderOfDepth * depth);
    return shape;
}

}  // namespace

glm::vec3 pushOf(const Hit& hit) {
    if (hit.form.direction != DentDirection::IntoSurface) {
        return hit.direction;
    }
    const glm::vec3 normal = unitNormal(hit);
    return normal == glm::vec3(0.0f) ? hit.direction : glm::vec3(-normal.x, -normal.y, -normal.z);
}

DentShape dentShapeOf(const Hit& hit) {
    if (hit.form.presses()) {
        return pressOf(hit);
    }
    DentShape shape;
    shape.point = hit.point;
    shape.reach = hit.constants.maxDistance;
    shape.direction = pushOf(hit);
    shape.power = hit.constants.power;
    shape.magnitude = hit.constants.maxMagnitude;
    shape.kind = static_cast<DentKind>(hit.form.profile);
    if (shape.kind == DentKind::Curve) {
        shape.curve = termsOf(hit.form.curve);
    }
    return shape;
}

HitReach reachOf(const Hit& hit) {
    if (!hit.form.presses()) {
        return {hit.point, hit.constants.maxDistance};
    }
    const DentShape shape = pressOf(hit);
    return {shape.point, shape.reach};
}

float farthestPush(const Hit& hit) {
    // A vertex as far back as the reach goes, out at the front.
    return hit.form.presses() ? (kReachInRadii + 1.0f) * hit.form.radius : hit.constants.maxMagnitude;
}

}  // namespace hitscope
