// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "deform/dent_form.h"
#include "deform/hit.h"

namespace hitscope {

/// The function that tells how far a vertex moves. deform.glsl knows them by these numbers.
enum class DentKind : std::uint8_t { Paper, Smooth, Wendland, Linear, Crater, Curve, Press };

/// What deform() needs of a hit, worked out once for all vertices, so that the CPU and the GPU have the same
/// bits of it.
struct DentShape {
    glm::vec3 point{0.0f};      ///< metres: the hit's; of a press: the sphere's centre
    float reach = 0.0f;         ///< metres: no vertex farther from `point` moves
    glm::vec3 direction{0.0f};  ///< unit: which way vertices move
    float power = 0.0f;         ///< square metres; of a press: the sphere's radius, metres
    float magnitude = 0.0f;     ///< metres: max_magnitude; of a press: half as wide as its shoulder
    DentKind kind = DentKind::Paper;
    CurveTerms curve{};  ///< of DentKind::Curve
};

/// `hit` has passed checkedHit().
[[nodiscard]] DentShape dentShapeOf(const Hit& hit);

/// Which way the vertices move that the hit reaches; unit, local frame.
[[nodiscard]] glm::vec3 pushOf(const Hit& hit);

/// Within this sphere are all vertices that the hit moves, where they are before it. Metres, local frame.
struct HitReach {
    glm::vec3 centre{0.0f};
    float radius = 0.0f;
};
[[nodiscard]] HitReach reachOf(const Hit& hit);

/// Metres: no vertex moves farther.
[[nodiscard]] float farthestPush(const Hit& hit);

}  // namespace hitscope
