// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>

#include "core/parameter.h"
#include "deform/dent_form.h"

namespace hitscope {

inline constexpr float kEarthGravity = 9.81f;  ///< m/s^2

/// How projectiles are shot. The defaults are the paper's reference scene.
struct ProjectileSettings {
    float radius = 0.1f;        ///< metres
    float mass = 1.0f;          ///< kilograms
    float speed = 30.0f;        ///< m/s
    float lifetime = 5.0f;      ///< seconds after which a projectile disappears
    bool bouncesCount = false;  ///< false: one flight makes one hit at most
    float rateOfFire = 8.0f;    ///< shots a second while the trigger is held
    int mostAlive = 500;        ///< the oldest goes when one more is shot
    /// The deformation's power is multiplied by impulse / referenceImpulse; the paper's is constant.
    bool powerFollowsImpulse = false;
    float referenceImpulse = 40.8f;         ///< newton seconds; the default: of the default shot, head on
    glm::vec3 colour{0.90f, 0.58f, 0.30f};  ///< sRGB, [0, 1]; what a projectile looks like in flight
    float gravity = kEarthGravity;          ///< m/s^2, downwards: how it falls
    bool passesOthers = false;              ///< it passes through all other projectiles
    std::optional<DentForm> form = {};      ///< of the dents it makes; nothing: the session's setting

    bool operator==(const ProjectileSettings&) const = default;
};

/// speed, radius, mass, lifetime, rate_of_fire, most_alive, reference_impulse, gravity, in this order. Wide
/// enough for targets from 0.1 mm to 100 km across.
[[nodiscard]] const std::array<ParameterDescriptor, 8>& projectileParameters();
[[nodiscard]] double parameterValue(const ProjectileSettings& settings, std::size_t index);
void setParameterValue(ProjectileSettings& settings, std::size_t index, double value);

/// With every number within its descriptor's range, and the colour within its own; what is not finite becomes
/// the default.
[[nodiscard]] ProjectileSettings clamped(const ProjectileSettings& settings);

/// Whether a target stays where it was put, as in the paper, or is dynamic: moves when hit.
struct TargetPhysics {
    bool isDynamic = false;
    float mass = 100.0f;       ///< kilograms; of a dynamic target
    float friction = 0.6f;     ///< Bullet's coefficient
    float restitution = 0.6f;  ///< how much of the speed a bounce gives back, with the other's as a product

    bool operator==(const TargetPhysics&) const = default;
};

/// mass, friction, restitution, in this order.
[[nodiscard]] const std::array<ParameterDescriptor, 3>& targetParameters();
[[nodiscard]] double parameterValue(const TargetPhysics& physics, std::size_t index);
void setParameterValue(TargetPhysics& physics, std::size_t index, double value);
[[nodiscard]] TargetPhysics clamped(const TargetPhysics& physics);

/// Of the world's clock: the fixed step in seconds, and how fast simulated time goes beside real time.
[[nodiscard]] const ParameterDescriptor& stepParameter();
[[nodiscard]] const ParameterDescriptor& timeScaleParameter();

}  // namespace hitscope
