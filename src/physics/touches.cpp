// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/touches.h"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include "physics/bullet_conversions.h"

namespace hitscope::physics {
namespace {

// Bullet keeps contact points of bodies that are near but not there yet; a sphere that rolls over edges
// hovers by about this much.
constexpr float kTouchDistance = 0.002f;

void add(Touch& touch, const btPersistentManifold& manifold, bool targetIsB) {
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
        const btManifoldPoint& point = manifold.getContactPoint(i);
        const float impulse = point.getAppliedImpulse();
        if (impulse <= 0.0f && point.getDistance() > kTouchDistance) {
            continue;
        }
        touch.impulse += impulse;
        if (point.getDistance() < touch.distance) {
            touch.distance = point.getDistance();
            const btVector3& position = targetIsB ? point.getPositionWorldOnB() : point.getPositionWorldOnA();
            const btVector3 normal = targetIsB ? point.m_normalWorldOnB : -point.m_normalWorldOnB;
            const int triangle = targetIsB ? point.m_index1 : point.m_index0;
            touch.deepest = {fromBullet(position), fromBullet(normal), triangle};
        }
    }
}

}  // namespace

std::map<TouchKey, Touch> touches(btDispatcher& dispatcher) {
    std::map<TouchKey, Touch> result;
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
        const btCollisionObject* a = manifold.getBody0();
        const btCollisionObject* b = manifold.getBody1();
        const bool targetIsB = isKind(*b, BodyKind::Target);
        const btCollisionObject* target = targetIsB ? b : a;
        const btCollisionObject* projectile = targetIsB ? a : b;
        if (!isKind(*target, BodyKind::Target) || !isKind(*projectile, BodyKind::Projectile)) {
            continue;
        }
        Touch touch;
        add(touch, manifold, targetIsB);
        if (touch.impulse <= 0.0f && touch.distance > kTouchDistance) {
            continue;
        }
        const TouchKey key{{static_cast<std::uint32_t>(projectile->getUserIndex2())},
                           {static_cast<std::uint32_t>(target->getUserIndex2())}};
        const auto [known, isNew] = result.try_emplace(key, touch);
        if (!isNew) {
            known->second.impulse += touch.impulse;
            if (touch.distance < known->second.distance) {
                known->second.distance = touch.distance;
                known->second.deepest = touch.deepest;
            }
        }
    }
    return result;
}

}  // namespace hitscope::physics
