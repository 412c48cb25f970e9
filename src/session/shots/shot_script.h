// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "physics/projectile_settings.h"
#include "view/camera.h"

namespace hitscope {

class Session;

struct TimedShot {
    double time = 0.0;  ///< seconds of simulated time after the script's start, >= 0
    Ray ray;            ///< world

    bool operator==(const TimedShot& other) const {
        return time == other.time && ray.origin == other.ray.origin && ray.direction == other.ray.direction;
    }
};

/// Shots that can be repeated: the same session, script and physics step give the same hits.
struct ShotScript {
    /// How they are shot, and the form of their dents if it is the script's; the constants, and whether power
    /// follows the impulse, are the session's.
    ProjectileSettings projectile;
    bool isInstant = false;        ///< without flight
    std::vector<TimedShot> shots;  ///< by time

    /// Seconds from the start to the last shot; 0 for none.
    [[nodiscard]] double duration() const { return shots.empty() ? 0.0 : shots.back().time; }

    static constexpr int kMostShots = 100'000;
};

// What follows makes `count` shots (0 to ShotScript::kMostShots, or it is brought there), the first at once
// and then one every `interval` seconds (>= 0; 0: all at once, as one volley).

/// From the axis' origin, spread evenly over a cone about it. `halfAngle`: radians from the axis to its edge,
/// [0, pi]. The same seed gives the same shots on every machine.
[[nodiscard]] std::vector<TimedShot> burst(const Ray& axis, int count, float halfAngle, std::uint32_t seed,
                                           double interval = 0.0);
/// Evenly from one ray to the other: origins along a line, directions along the line between their ends one
/// metre ahead. Opposite directions have none between them and are passed over.
[[nodiscard]] std::vector<TimedShot> sweep(const Ray& from, const Ray& to, int count, double interval);
/// From the axis' origin, evenly around it, starting at the side of `up` (not along the axis) and going to
/// where cross(axis, up) points. `halfAngle`: radians, [0, pi].
[[nodiscard]] std::vector<TimedShot> circle(const Ray& axis, const glm::vec3& up, float halfAngle, int count,
                                            double interval);

/// The shots leave as the session's time goes on, from now.
void schedule(Session& session, const ShotScript& script);

}  // namespace hitscope
