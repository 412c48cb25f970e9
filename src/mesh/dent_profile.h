// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "mesh/dent.h"

namespace hitscope {

/// What a profile shows of its plane, metres: the dent and a margin around it.
struct ProfileFrame {
    double along = 0.0;   ///< on either side of the axis
    double lowest = 0.0;  ///< of heights
    double highest = 0.0;

    [[nodiscard]] bool contains(const ProfilePoint& point) const;
};

/// Three quarters of the rim's diameter on either side of the axis, and the heights of the dent's `vertices`
/// before and after with a quarter of the diameter above and below.
[[nodiscard]] ProfileFrame profileFrame(const DentMeasures& dent, const Plane& plane,
                                        std::span<const std::uint32_t> vertices,
                                        std::span<const glm::vec3> before, std::span<const glm::vec3> after);

/// The section's line at the dent: the connected piece within `frame` that is nearest to `at`, the place of
/// the dent's deepest vertex. Other walls that the plane cuts are left out. It ends on the frame's border
/// where it leaves it. Empty when no line is within.
[[nodiscard]] std::vector<ProfilePoint> profileLine(std::span<const SectionCurve> curves, const Plane& plane,
                                                    const DentMeasures& dent, const glm::vec3& deepestBefore,
                                                    const ProfileFrame& frame, const glm::vec3& at);

}  // namespace hitscope
