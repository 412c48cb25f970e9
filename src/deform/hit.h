// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "core/ids.h"
#include "core/result.h"
#include "deform/deformation_constants.h"
#include "deform/dent_form.h"
#include "deform/hit_group.h"
#include "mesh/mesh_data.h"

namespace hitscope {

/// Of Hit::pipeline: not known.
inline constexpr std::uint8_t kUnknownPipeline = 0xff;

/// One deformation of one target: where, which way, with which constants. Lives in the target's local frame,
/// so that it goes where the target goes.
struct Hit {
    TargetId target;
    glm::vec3 point{0.0f};                   ///< metres, local frame
    glm::vec3 direction{0.0f, 0.0f, -1.0f};  ///< unit vector, local frame
    DeformationConstants constants;          ///< in force when it was made
    double time = 0.0;                       ///< seconds of simulated time
    float speed = 0.0f;                      ///< m/s, of the projectile just before impact
    float impulse = 0.0f;                    ///< newton seconds, as Bullet applied it
    bool enabled = true;                     ///< off: it stays in the history and deforms nothing
    glm::vec3 normal{0.0f};  ///< unit, local frame: of the surface there, towards where it came from;
                             ///< zero: not known
    std::uint32_t triangle = kNoIndex;  ///< that it struck, of the render mesh; kNoIndex: not known, or an
                                        ///< undented primitive, which is struck as what it is
    std::uint8_t pipeline = kUnknownPipeline;  ///< that was active when it was made, as a number that who
                                               ///< makes hits gives a meaning; nothing here depends on it
    HitGroup group = {};                       ///< that it was made with

    glm::vec3 flight{0.0f};  ///< unit, local frame: `direction` as the projectile had it, where that was
                             ///< changed since; zero: it was not

    DentForm form = {};  ///< of its dent; the usual one is the paper's

    bool operator==(const Hit&) const = default;
};

/// With 0 for what is so small that deforming with it would give denormal numbers, which some renderers
/// flush.
[[nodiscard]] DeformationConstants withoutTiny(const DeformationConstants& constants);

/// A hit with its direction made unit length and its form plain(); an error for a non-finite number, a zero
/// direction, constants out of range or a form that no hit can have. Every way into a HitHistory passes
/// through here.
[[nodiscard]] Result<Hit> checkedHit(Hit hit);

}  // namespace hitscope
