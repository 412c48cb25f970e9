// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "deform/dent_shape.h"
#include "deform/hit.h"

namespace hitscope {

/// The deformation function (paper, Algorithm 3 and equations 1-4): moves `position` and turns `normal` if
/// the vertex is within max_distance of the hit. Returns whether it is. shaders/deform.glsl is its twin: the
/// same operations in the same order, each rounded to float, nothing contracted; tests/gl compares them bit
/// for bit. A hit of another form than the paper's has the function that its DentShape names.
bool deform(glm::vec3& position, glm::vec3& normal, const Hit& hit);
/// For many vertices: the shape is worked out once.
bool deform(glm::vec3& position, glm::vec3& normal, const DentShape& dent);

/// What deform() adds to a position, by the very same operations: position + displacement is what it makes of
/// it, to the last bit.
struct Contribution {
    float distance = 0.0f;   ///< metres: r
    float magnitude = 0.0f;  ///< metres: m; negative: against the direction, as a crater's rim
    bool isCapped = false;   ///< max_magnitude applied
    glm::vec3 displacement{0.0f};
};
/// Nothing: the position is out of the hit's reach.
[[nodiscard]] std::optional<Contribution> contributionTo(const glm::vec3& position, const Hit& hit);
/// Likewise; the distance is that to the shape's point.
[[nodiscard]] std::optional<Contribution> contributionTo(const glm::vec3& position, const DentShape& dent);

/// How far a vertex moves, metres, that is `distance` (metres) from the hit point on a plane which is hit
/// straight on: what a plot of the fall-off shows.
[[nodiscard]] float magnitudeOnPlane(const DentForm& form, const DeformationConstants& constants,
                                     float distance);

}  // namespace hitscope
