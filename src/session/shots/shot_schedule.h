// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <deque>
#include <span>
#include <vector>

#include "physics/projectile_settings.h"
#include "view/camera.h"

namespace hitscope {

/// A shot to come.
struct ScheduledShot {
    double delay = 0.0;  ///< seconds of simulated time from now, >= 0
    Ray ray;             ///< world
    ProjectileSettings settings;
    bool isInstant = false;  ///< without flight
};

/// Shots that leave by the physics' clock: each before the first step that begins when its delay is over,
/// however long frames take.
class ShotSchedule {
public:
    /// `now`: seconds of simulated time. Shots of the same delay leave in their order, and are one volley.
    /// `series` comes back with each of them.
    void add(std::span<const ScheduledShot> shots, double now, int series = 0);
    struct Due {
        ScheduledShot shot;
        int volley = 0;  ///< > 0: projectiles of it pass through each other; 0: none
        int series = 0;  ///< of add()
    };
    /// Whether one leaves before the step of `step` seconds that begins `now`.
    [[nodiscard]] bool isDue(double now, double step) const;
    [[nodiscard]] std::size_t countDue(double now, double step) const;
    [[nodiscard]] bool isNextInstant() const { return m_waiting.front().due.shot.isInstant; }  ///< size() > 0
    [[nodiscard]] Due takeNext();                                                              ///< size() > 0
    void clear() { m_waiting.clear(); }
    [[nodiscard]] std::size_t size() const { return m_waiting.size(); }

private:
    struct Waiting {
        Due due;
        double time = 0.0;  ///< simulated
    };
    std::deque<Waiting> m_waiting;  ///< by time; of the same time, in the order added
    int m_lastVolley = 0;
};

}  // namespace hitscope
