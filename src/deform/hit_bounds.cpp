// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/hit_bounds.h"

#include <algorithm>
#include <cmath>
#include <glm/vector_relational.hpp>

#include "deform/dent_shape.h"

namespace hitscope {
namespace {

// deform() decides and moves in float: this is what its rounding, and ours, can add, as a part of the numbers
// involved. Sixteen units in float's last place, where the sums in question lose a few.
constexpr float kRounding = 1e-6f;

float largestCoordinate(const glm::vec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// How far vertices may move along the direction, metres; negative: against it.
struct Push {
    float least = 0.0f;
    float most = 0.0f;
};

/// By power / maxDistance at least and by what it is at the nearest place at most (eq. 4).
Push paperPush(const Hit& hit, float nearest, float reach) {
    const float cap = hit.constants.maxMagnitude;
    const float most = nearest > 0.0f ? std::min(hit.constants.power / nearest, cap) : cap;
    return {std::min(hit.constants.power / reach, most), most};
}

/// The farther a vertex lies back, the farther it is pushed: out at the sphere's front, which no part of the
/// shoulder is before.
Push pressPush(const DentShape& press, const Bounds& part) {
    float back = 0.0f;
    for (glm::length_t i = 0; i < 3; ++i) {
        back += std::min((part.min[i] - press.point[i]) * press.direction[i],
                         (part.max[i] - press.point[i]) * press.direction[i]);
    }
    return {0.0f, std::clamp(press.power - back, 0.0f, press.power + press.reach) + press.magnitude};
}

/// `part`: of a cluster's box, within reach. `nearest`: metres from the hit's point to it.
Push pushWithin(const Hit& hit, const Bounds& part, float nearest, float reach) {
    const float cap = hit.constants.maxMagnitude;
    constexpr float kCraterRim = 0.25f;  // of its depth
    if (hit.form.presses()) {
        return pressPush(dentShapeOf(hit), part);
    }
    switch (hit.form.profile) {
        case DentProfile::Paper:
            return paperPush(hit, nearest, reach);
        case DentProfile::Smooth:
            return {0.0f, paperPush(hit, nearest, reach).most};
        case DentProfile::Crater:
            return {-kCraterRim * cap, cap};
        case DentProfile::Curve: {
            const auto [lowest, highest] = std::minmax_element(hit.form.curve.begin(), hit.form.curve.end());
            return {std::min(*lowest, 0.0f) * cap, std::max(*highest, 0.0f) * cap};
        }
        default:
            return {0.0f, cap};
    }
}

}  // namespace

float withRounding(float reach) {
    return reach * (1.0f + 2.0f * kRounding);
}

bool reaches(const HitReach& hit, const Bounds& box) {
    const float reach = withRounding(hit.radius);
    return distanceSquared(box, hit.centre) <= reach * reach;
}

Bounds movedBy(const Bounds& box, const Hit& hit) {
    const HitReach sphere = reachOf(hit);
    const float reach = withRounding(sphere.radius);
    Bounds part;
    part.min = glm::max(box.min, sphere.centre - reach);
    part.max = glm::min(box.max, sphere.centre + reach);
    if (glm::any(glm::greaterThan(part.min, part.max))) {
        return {};
    }
    const float nearest = std::sqrt(distanceSquared(box, sphere.centre)) * (1.0f - 2.0f * kRounding);
    const Push push = pushWithin(hit, part, nearest, reach);
    const float slack = kRounding * (std::max({largestCoordinate(part.min), largestCoordinate(part.max),
                                               largestCoordinate(sphere.centre)}) +
                                     reach + push.most);
    const glm::vec3 direction = pushOf(hit);
    const glm::vec3 shortest = direction * push.least;
    const glm::vec3 longest = direction * push.most;
    Bounds moved = part;
    moved.add(Bounds{part.min + glm::min(shortest, longest) - slack,
                     part.max + glm::max(shortest, longest) + slack});
    return moved;
}

std::optional<Bounds> changedBy(std::span<const Hit> before, std::span<const Hit> after,
                                std::span<const Hit> later) {
    constexpr std::size_t kMost = 256;  // hits
    if (before.size() + after.size() + later.size() > kMost) {
        return std::nullopt;
    }
    Bounds all;
    for (const std::span<const Hit> some : {before, after}) {
        Bounds box;
        for (const Hit& hit : some) {
            const HitReach sphere = reachOf(hit);
            const float reach = withRounding(sphere.radius);
            box.add(Bounds{sphere.centre - reach, sphere.centre + reach});
            box.add(movedBy(box, hit));
        }
        all.add(box);
    }
    for (const Hit& hit : later) {
        if (reaches(reachOf(hit), all)) {
            all.add(movedBy(all, hit));
        }
    }
    return all;
}

}  // namespace hitscope
