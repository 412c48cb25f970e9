// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/flight_mode.h"

#include <algorithm>

#include "session/constants_setting.h"

namespace hitscope {

namespace {

constexpr float kQuickLifetime = 1.0f;  // seconds: it has struck long before, or never will
constexpr float kLargestPart = 0.25f;   // of the distance: a larger projectile would start in the target

void takeFlight(ProjectileSettings& to, const ProjectileSettings& from) {
    to.radius = from.radius;
    to.speed = from.speed;
    to.lifetime = from.lifetime;
    to.gravity = from.gravity;
}

}  // namespace

const std::array<FlightModeTraits, 4>& allFlightModes() {
    static const std::array<FlightModeTraits, 4> modes{{
        {FlightMode::Quick, "quick", "Quick",
         "A projectile flies to where you click in a tenth of a second. Its size, speed and fall go by the "
         "size of the target and its distance."},
        {FlightMode::Instant, "instant", "Instant",
         "No flight: the hit is made where you click, in the next frame."},
        {FlightMode::Paper, "paper", "As in the paper",
         "A projectile 20 cm across flies at 30 m/s for 5 seconds at most, whatever the size of the target."},
        {FlightMode::Own, "own", "Own numbers",
         "A projectile flies with the speed, radius, lifetime and gravity that are set in Shoot > "
         "Projectile."},
    }};
    return modes;
}

ProjectileSettings projectileOf(FlightMode mode, const ProjectileSettings& own, float extent,
                                float distance) {
    const ProjectileSettings paper;
    ProjectileSettings shot = own;
    if (mode == FlightMode::Own) {
        return clamped(shot);
    }
    takeFlight(shot, paper);
    if (mode == FlightMode::Paper) {
        return clamped(shot);
    }
    const float factor = sizeFactor(extent);
    shot.radius = paper.radius * factor;
    shot.gravity = paper.gravity * factor;
    if (mode == FlightMode::Quick) {
        shot.radius = distance > 0.0f ? std::min(shot.radius, kLargestPart * distance) : shot.radius;
        shot.speed = std::max(distance / kQuickFlight, paper.speed * factor);
        shot.mass = own.mass * (paper.speed / shot.speed);
        shot.lifetime = kQuickLifetime;
        shot.passesOthers = true;  // on its way back it would be in the way of the next
    }
    return clamped(shot);
}

}  // namespace hitscope
