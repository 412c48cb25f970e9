// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/projectile_settings.h"

#include <algorithm>
#include <cmath>

#include "physics/physics_world.h"

namespace hitscope {
namespace {

// Without defaults, which the settings themselves have.
constexpr std::array<ParameterDescriptor, 8> kProjectileParameters{{
    {.key = "speed",
     .label = "Speed",
     .unit = "m/s",
     .description = "Speed at which a projectile leaves the eye.",
     .minimum = 0.0,
     .maximum = 1.0e9,
     .step = 1.0,
     .decimals = 6},
    {.key = "radius",
     .label = "Radius",
     .unit = "m",
     .description = "Radius of the sphere that is shot.",
     .minimum = 1.0e-7,
     .maximum = 1.0e5,
     .step = 0.01,
     .decimals = 7},
    {.key = "mass",
     .label = "Mass",
     .unit = "kg",
     .description = "Mass of the sphere; decides the impulse of a hit.",
     .minimum = 1.0e-9,
     .maximum = 1.0e9,
     .step = 0.1,
     .decimals = 9},
    {.key = "lifetime",
     .label = "Lifetime",
     .unit = "s",
     .description = "A projectile disappears this long after its shot.",
     .minimum = 0.0,
     .maximum = 3600.0,
     .step = 0.5,
     .decimals = 1},
    {.key = "rate_of_fire",
     .label = "Rate of fire",
     .unit = "1/s",
     .description = "Shots a second while the trigger, Space, is held.",
     .minimum = 0.1,
     .maximum = 240.0,
     .step = 1.0,
     .decimals = 1},
    {.key = "most_alive",
     .label = "Max projectiles",
     .unit = "",
     .description = "Maximum number of projectiles in flight. The oldest is removed when one more is shot.",
     .minimum = 1.0,
     .maximum = 5000.0,
     .step = 100.0,
     .decimals = 0},
    {.key = "reference_impulse",
     .label = "Reference impulse",
     .unit = "N s",
     .description = "Where power follows the impulse: a hit of this impulse has the power that is set.",
     .minimum = 0.001,
     .maximum = 1000000.0,
     .step = 1.0,
     .decimals = 3},
    {.key = "gravity",
     .label = "Gravity",
     .unit = "m/s²",
     .description = "How fast a projectile's fall gets faster.",
     .minimum = 0.0,
     .maximum = 1.0e7,
     .step = 1.0,
     .decimals = 6},
}};

constexpr std::array<ParameterDescriptor, 3> kTargetParameters{{
    {.key = "mass",
     .label = "Mass",
     .unit = "kg",
     .description = "Mass of a dynamic target.",
     .minimum = 0.001,
     .maximum = 1000000.0,
     .step = 10.0,
     .decimals = 3},
    {.key = "friction",
     .label = "Friction",
     .unit = "",
     .description = "Friction of the target's surface.",
     .minimum = 0.0,
     .maximum = 10.0,
     .step = 0.1,
     .decimals = 2},
    {.key = "restitution",
     .label = "Restitution",
     .unit = "",
     .description = "Part of its speed that a projectile keeps when it bounces off.",
     .minimum = 0.0,
     .maximum = 1.0,
     .step = 0.1,
     .decimals = 2},
}};

template <class Settings, class Parameters>
Settings clampedBy(Settings settings, const Parameters& parameters) {
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const ParameterDescriptor& parameter = parameters[i];
        const double value = parameterValue(settings, i);
        setParameterValue(settings, i,
                          std::isfinite(value) ? std::clamp(value, parameter.minimum, parameter.maximum)
                                               : parameter.defaultValue);
    }
    return settings;
}

}  // namespace

const std::array<ParameterDescriptor, 8>& projectileParameters() {
    static const auto parameters = withDefaultsOf(ProjectileSettings{}, kProjectileParameters);
    return parameters;
}

double parameterValue(const ProjectileSettings& settings, std::size_t index) {
    const double values[] = {static_cast<double>(settings.speed),
                             static_cast<double>(settings.radius),
                             static_cast<double>(settings.mass),
                             static_cast<double>(settings.lifetime),
                             static_cast<double>(settings.rateOfFire),
                             static_cast<double>(settings.mostAlive),
                             static_cast<double>(settings.referenceImpulse),
                             static_cast<double>(settings.gravity)};
    return values[index];
}

void setParameterValue(ProjectileSettings& settings, std::size_t index, double value) {
    constexpr std::size_t kMostAlive = 5;  // the one that is not a float
    if (index == kMostAlive) {
        settings.mostAlive = static_cast<int>(std::lround(value));
        return;
    }
    float* const numbers[] = {&settings.speed,
                              &settings.radius,
                              &settings.mass,
                              &settings.lifetime,
                              &settings.rateOfFire,
                              nullptr,
                              &settings.referenceImpulse,
                              &settings.gravity};
    *numbers[index] = static_cast<float>(value);
}

ProjectileSettings clamped(const ProjectileSettings& settings) {
    ProjectileSettings usable = clampedBy(settings, projectileParameters());
    for (int i = 0; i < 3; ++i) {
        const float part = settings.colour[i];
        usable.colour[i] =
            std::isfinite(part) ? std::clamp(part, 0.0f, 1.0f) : ProjectileSettings().colour[i];
    }
    return usable;
}

const std::array<ParameterDescriptor, 3>& targetParameters() {
    static const auto parameters = withDefaultsOf(TargetPhysics{}, kTargetParameters);
    return parameters;
}

double parameterValue(const TargetPhysics& physics, std::size_t index) {
    const float values[] = {physics.mass, physics.friction, physics.restitution};
    return static_cast<double>(values[index]);
}

void setParameterValue(TargetPhysics& physics, std::size_t index, double value) {
    float* const numbers[] = {&physics.mass, &physics.friction, &physics.restitution};
    *numbers[index] = static_cast<float>(value);
}

TargetPhysics clamped(const TargetPhysics& physics) {
    return clampedBy(physics, targetParameters());
}

const ParameterDescriptor& stepParameter() {
    static const ParameterDescriptor parameter{
        .key = "physics_step",
        .label = "Physics step",
        .unit = "s",
        .description = "Simulated time goes in steps of this length, however long a frame takes.",
        .defaultValue = StepClock::kStep,
        .minimum = 1.0 / 2000.0,
        .maximum = 1.0 / 60.0,
        .step = 0.001,
        .decimals = 5};
    return parameter;
}

const ParameterDescriptor& timeScaleParameter() {
    static const ParameterDescriptor parameter{
        .key = "time_scale",
        .label = "Time scale",
        .unit = "",
        .description = "How fast simulated time goes: 1 as real time does, 0.1 for slow motion.",
        .defaultValue = 1.0,
        .minimum = 0.01,
        .maximum = 10.0,
        .step = 0.1,
        .decimals = 2};
    return parameter;
}

}  // namespace hitscope
