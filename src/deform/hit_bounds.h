// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "core/bounds.h"
#include "deform/hit.h"

namespace hitscope {

struct HitReach;

/// `reach` (metres) and what rounding in deform() can add.
[[nodiscard]] float withRounding(float reach);
/// Square of the distance from `point` to the box; infinite if that is empty.
[[nodiscard]] inline float distanceSquared(const Bounds& box, const glm::vec3& point) {
    const glm::vec3 gap = glm::max(glm::max(box.min - point, point - box.max), glm::vec3(0.0f));
    return gap.x * gap.x + gap.y * gap.y + gap.z * gap.z;
}
/// Whether there may be a vertex in the box that the hit moves.
[[nodiscard]] bool reaches(const HitReach& hit, const Bounds& box);
/// Wherever vertices in the box that the hit moves are before it and after it; empty: it moves none. They are
/// within reach before, and move along the direction.
[[nodiscard]] Bounds movedBy(const Bounds& box, const Hit& hit);
/// Wherever vertices are that come out otherwise where `after` takes the place of `before` and the hits
/// `later` follow either: as they were and as they are. Nothing: these are too many to tell it in no time.
[[nodiscard]] std::optional<Bounds> changedBy(std::span<const Hit> before, std::span<const Hit> after,
                                              std::span<const Hit> later);

}  // namespace hitscope
