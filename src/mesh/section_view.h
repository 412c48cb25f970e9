// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mesh/section.h"

namespace hitscope {

/// How a section is laid out flat: two directions in its plane, as one sees it from the side that `towards`
/// points to. Where a direction is one of the world's axes, coordinates along it are that axis's own, and it
/// is shown mirrored if need be; else they count from the foot of the world's origin.
struct SectionView {
    struct Axis {
        glm::vec3 direction{1.0f, 0.0f, 0.0f};  ///< unit
        bool mirrored = false;                  ///< grows to the left, or downwards
        char name = 0;                          ///< 'x', 'y', 'z'; 0: none of the world's
    };
    Axis right;
    Axis up{{0.0f, 1.0f, 0.0f}, false, 'y'};

    /// Metres along both; double, since plots are.
    [[nodiscard]] glm::dvec2 operator()(const glm::vec3& point) const;
};

/// `towards` unit, at right angles to the plane. Up is the world's y, or -z where that is the normal.
[[nodiscard]] SectionView sectionView(const glm::vec3& towards);

/// How deep a deformed section's corners lie: for each point of each curve in turn, the nearest place on the
/// original's section in the same plane. That needs no partner for a point and is 0 where nothing has moved;
/// dents that slide along the surface count only as far as they leave its outline.
struct SectionDepths {
    std::vector<std::vector<glm::vec3>> nearest;  ///< as `deformed`: a place on the original's lines
    std::vector<std::vector<float>> depths;       ///< metres, to there; empty without an original
    std::optional<float> greatest;                ///< of them; nothing: there is none
    std::size_t curve = 0;                        ///< where that is
    std::size_t point = 0;
};
/// Where the plane does not cut the original, there is nothing to compare with: no depths, no nearest places.
[[nodiscard]] SectionDepths sectionDepths(std::span<const SectionCurve> original,
                                          std::span<const SectionCurve> deformed);

}  // namespace hitscope
