// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "deform/hit.h"
#include "mesh/section.h"

namespace hitscope {

/// The same hit on the other side of a plane (local frame): its point, direction and normal are mirrored; the
/// triangle there is not known, and it is of no group. Across a plane at right angles to an axis and through
/// the origin no number is rounded, so that a mesh that is symmetric in every bit is so again after both.
/// `hit` has passed checkedHit().
[[nodiscard]] Hit mirrored(const Hit& hit, const Plane& plane);

/// That of each hit whose mirror image is another one: a hit in the plane that goes along it is its own.
[[nodiscard]] std::vector<Hit> mirroredHits(std::span<const Hit> hits, const Plane& plane);

}  // namespace hitscope
