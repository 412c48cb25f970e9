// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/aiming.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "session/paced_advance.h"
#include "session/session.h"
#include "session/target.h"
#include "view/cutting_plane.h"
#include "viewport/aim.h"
#include "viewport/navigation.h"

namespace hitscope {

namespace {

constexpr float kAimLength = 8.0f;  // how far aiming looks, in camera distances plus scene sizes

/// Of the largest target that is shown, metres; of a scene without: what the paper's targets have.
float largestExtent(const Session& session) {
    float largest = 0.0f;
    for (const std::unique_ptr<Target>& target : session.targets()) {
        largest = target->visible ? std::max(largest, target->extent()) : largest;
    }
    return largest > 0.0f ? largest : kUsualExtent;
}

}  // namespace

std::optional<PhysicsWorld::RayHit> Aiming::met(const Ray& ray) const {
    m_session.simulation().updateColliders(workLimit());
    const float length =
        kAimLength * (m_navigation.camera().distance() + m_session.targets().bounds().diagonal());
    const std::optional<ShownRay> shown = shownPart(m_cut, ray, length);
    if (shown) {
        const auto met =
            m_session.simulation().physics().castRay(shown->ray.origin, shown->ray.direction, shown->length);
        if (met || !m_cut.on) {
            return met;
        }
    }
    // The floor is whole.
    const auto beyond = m_session.simulation().physics().castRay(ray.origin, ray.direction, length);
    return beyond && !beyond->target ? beyond : std::nullopt;
}

Aiming::Aim Aiming::aim(const Ray& sight) const {
    const auto met = this->met(sight);
    Aim aim;
    aim.from = shotAlong(sight, m_navigation.camera(), met ? std::optional(met->point) : std::nullopt);
    // What is cut away is not in its way.
    if (const auto shown = shownPart(m_cut, aim.from, std::numeric_limits<float>::max())) {
        aim.from = shown->ray;
    }
    const Target* target = met ? m_session.targets().find(met->target) : nullptr;
    aim.extent = target != nullptr ? target->extent() : largestExtent(m_session);
    aim.distance = m_navigation.camera().distance();
    if (met && met->point != aim.from.origin) {
        aim.to = met->point;
        aim.distance = glm::distance(met->point, aim.from.origin);
    }
    return aim;
}

ProjectileSettings Aiming::projectileFor(const Ray& sight) const {
    const Aim at = aim(sight);
    return projectileOf(m_session.settings().flightMode(), m_session.settings().projectile(), at.extent,
                        at.distance);
}

Ray Aiming::launched(const Ray& sight, const ProjectileSettings& projectile) const {
    const Aim at = aim(sight);
    Ray shot = at.from;
    if (at.to) {
        shot.direction = launchDirection(shot.origin, *at.to, projectile.speed, projectile.gravity);
    }
    return shot;
}

ScheduledShot Aiming::shotAt(const Ray& sight) const {
    const ProjectileSettings projectile = projectileFor(sight);
    const bool isInstant = m_session.settings().flightMode() == FlightMode::Instant;
    return {0.0, isInstant ? aim(sight).from : launched(sight, projectile), projectile, isInstant};
}

}  // namespace hitscope
