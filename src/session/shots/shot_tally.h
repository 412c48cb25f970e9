// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "physics/physics_world.h"

namespace hitscope {

/// What has become of the shots of one click or one series so far.
struct ShotCount {
    std::size_t shots = 0;  ///< fired, or to be fired
    std::size_t fired = 0;
    std::size_t hits = 0;    ///< shots that made a hit, or more than one
    std::size_t flying = 0;  ///< shots under way that have made no hit
    std::size_t landed = 0;  ///< shots that struck the floor and made no hit so far
    std::size_t past = 0;    ///< shots that struck nothing
    TargetId lastHit;        ///< what the last of the hits is on; 0: none

    /// All are fired, and have hit or are gone.
    [[nodiscard]] bool isOver() const { return fired == shots && flying == 0; }
    bool operator==(const ShotCount&) const = default;
};

/// Counts the shots of each series, from its beginning until it is over. Costs by the event.
class ShotTally {
public:
    int begin(std::size_t shots);  ///< a new series; > 0
    void launched(int series, ProjectileId projectile);
    /// An instant shot: hit `target`, or none (0), and then perhaps the floor.
    void struckAtOnce(int series, TargetId target, bool floor);
    void hit(ProjectileId projectile, TargetId target);
    void follow(const PhysicsWorld::FlightEvent& event);
    /// What is not fired yet never will be.
    void stopFiring();
    /// Under way, and struck nothing so far.
    [[nodiscard]] bool hasShotsInAir() const;
    /// Forgets these, as if they had not been fired; returns them.
    std::vector<ProjectileId> recall();
    void clear();

    /// The counts that have changed since the last call, in the order of their series. A series that is over
    /// comes for the last time.
    [[nodiscard]] std::vector<ShotCount> takeChanged();

private:
    struct Flight {
        int series = 0;
        bool hasHit = false;
        bool hasLanded = false;
        [[nodiscard]] bool isInAir() const { return !hasHit && !hasLanded; }
    };
    struct Series {
        ShotCount count;
        bool changed = true;
    };
    Series* seriesOf(int id);

    std::map<int, Series> m_series;
    std::map<ProjectileId, Flight> m_flights;  ///< under way
    int m_last = 0;
};

}  // namespace hitscope
