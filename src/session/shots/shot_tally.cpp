// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/shots/shot_tally.h"

#include <algorithm>

namespace hitscope {

int ShotTally::begin(std::size_t shots) {
    m_series[++m_last].count.shots = shots;
    return m_last;
}

ShotTally::Series* ShotTally::seriesOf(int id) {
    const auto found = m_series.find(id);
    if (found == m_series.end()) {
        return nullptr;
    }
    found->second.changed = true;
    return &found->second;
}

void ShotTally::launched(int series, ProjectileId projectile) {
    Series* of = seriesOf(series);
    if (of == nullptr) {
        return;
    }
    ++of->count.fired;
    if (projectile) {
        ++of->count.flying;
        m_flights[projectile].series = series;
    } else {
        ++of->count.past;  // it could not be launched
    }
}

void ShotTally::struckAtOnce(int series, TargetId target, bool floor) {
    if (Series* of = seriesOf(series)) {
        ++of->count.fired;
        ++(target ? of->count.hits : floor ? of->count.landed : of->count.past);
        of->count.lastHit = target ? target : of->count.lastHit;
    }
}

void ShotTally::hit(ProjectileId projectile, TargetId target) {
    const auto flight = m_flights.find(projectile);
    if (flight == m_flights.end() || flight->second.hasHit) {
        return;
    }
    flight->second.hasHit = true;
    if (Series* of = seriesOf(flight->second.series)) {
        ++of->count.hits;
        --of->count.flying;
        of->count.landed -= flight->second.hasLanded ? 1 : 0;
        of->count.lastHit = target;
    }
}

void ShotTally::follow(const PhysicsWorld::FlightEvent& event) {
    const auto flight = m_flights.find(event.projectile);
    if (flight == m_flights.end()) {
        return;
    }
    const bool isOver = event.kind == PhysicsWorld::FlightEvent::Kind::Over;
    Series* of = flight->second.hasHit ? nullptr : seriesOf(flight->second.series);
    if (of != nullptr && isOver) {
        --of->count.flying;
        of->count.past += flight->second.hasLanded ? 0 : 1;
    } else if (of != nullptr) {
        flight->second.hasLanded = true;
        ++of->count.landed;
    }
    if (isOver) {
        m_flights.erase(flight);
    }
}

void ShotTally::stopFiring() {
    for (auto& [id, series] : m_series) {
        series.changed = series.changed || series.count.shots != series.count.fired;
        series.count.shots = series.count.fired;
    }
}

bool ShotTally::hasShotsInAir() const {
    return std::any_of(m_flights.begin(), m_flights.end(),
                       [](const auto& flight) { return flight.second.isInAir(); });
}

std::vector<ProjectileId> ShotTally::recall() {
    std::vector<ProjectileId> recalled;
    for (auto flight = m_flights.begin(); flight != m_flights.end();) {
        if (!flight->second.isInAir()) {
            ++flight;
            continue;
        }
        recalled.push_back(flight->first);
        if (Series* of = seriesOf(flight->second.series)) {
            --of->count.shots;
            --of->count.fired;
            --of->count.flying;
            if (of->count.shots == 0) {
                m_series.erase(flight->second.series);
            }
        }
        flight = m_flights.erase(flight);
    }
    return recalled;
}

void ShotTally::clear() {
    m_series.clear();
    m_flights.clear();
}

std::vector<ShotCount> ShotTally::takeChanged() {
    std::vector<ShotCount> changed;
    for (auto it = m_series.begin(); it != m_series.end();) {
        if (it->second.changed) {
            it->second.changed = false;
            changed.push_back(it->second.count);
        }
        it = it->second.count.isOver() ? m_series.erase(it) : std::next(it);
    }
    return changed;
}

}  // namespace hitscope
