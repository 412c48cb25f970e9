// SPDX-License-Identifier: GPL-3.0-or-later
// Shots to come, and the volleys they leave in.
#include <algorithm>

#include "physics/physics_world.h"
#include "physics/world_private.h"

namespace hitscope {

using namespace physics;

namespace {

constexpr double kRounding = 1.0e-6;  // of a step: times that are sums of steps are due at that step

int volleyOf(const btBroadphaseProxy& proxy) {
    const auto* body = static_cast<const btCollisionObject*>(proxy.m_clientObject);
    return isKind(*body, BodyKind::Projectile) ? body->getUserIndex3() : 0;
}

}  // namespace

bool VolleyFilter::needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const {
    if ((a->m_collisionFilterGroup & b->m_collisionFilterMask) == 0 ||
        (b->m_collisionFilterGroup & a->m_collisionFilterMask) == 0) {
        return false;
    }
    const int volley = volleyOf(*a);
    return volley <= 0 || volley != volleyOf(*b);
}

void PhysicsWorld::schedule(std::span<const ScheduledShot> shots) {
    std::vector<Private::Waiting> added;
    added.reserve(shots.size());
    for (const ScheduledShot& shot : shots) {
        added.push_back({shot, d->time() + std::max(0.0, shot.delay)});
    }
    const auto isEarlier = [](const Private::Waiting& a, const Private::Waiting& b) { return a.due < b.due; };
    std::stable_sort(added.begin(), added.end(), isEarlier);
    for (std::size_t i = 0; i < added.size(); ++i) {
        const bool withLast = i > 0 && added[i - 1].due == added[i].due;
        const bool withNext = i + 1 < added.size() && added[i + 1].due == added[i].due;
        if (withLast) {
            added[i].volley = added[i - 1].volley;
        } else if (withNext) {
            added[i].volley = ++d->lastVolley;
        }
    }
    d->scheduled.insert(d->scheduled.end(), added.begin(), added.end());
    std::stable_sort(d->scheduled.begin(), d->scheduled.end(), isEarlier);
}

void PhysicsWorld::cancelScheduled() {
    d->scheduled.clear();
}

std::size_t PhysicsWorld::scheduledCount() const {
    return d->scheduled.size();
}

void PhysicsWorld::Private::fireScheduled(std::vector<Impact>& impacts) {
    while (!scheduled.empty() && scheduled.front().due <= time() + kRounding * stepSeconds) {
        const Waiting next = scheduled.front();
        scheduled.pop_front();
        if (!next.shot.isInstant) {
            launch(next.shot, next.volley);
        } else if (const auto impact = hitscan(next.shot)) {
            impacts.push_back(*impact);
        }
    }
}

}  // namespace hitscope
