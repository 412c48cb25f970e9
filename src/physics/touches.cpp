// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/touches.h"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>

#include "physics/bullet_conversions.h"

namespace hitscope::physics {
namespace {

// Bullet keeps contact points of bodies that are near but not there yet; a sphere that rolls over edges
// hovers by about this much of its radius.
constexpr float kTouchDistance = 0.02f;

void add(Touch& touch, const btPersistentManifold& manifold, bool targetIsB, float near) {
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
        const btManifoldPoint& point = manifold.getContactPoint(i);
        const float impulse = point.getAppliedImpulse();
        if (impulse <= 0.0f && point.getDistance() > near) {
            continue;
        }
        const btVector3 normal = targetIsB ? point.m_normalWorldOnB : -point.m_normalWorldOnB;
        // Bullet has friction act on the first body, as the normal of the second points to it.
        const btVector3 friction = point.m_lateralFrictionDir1 * point.m_appliedImpulseLateral1;
        touch.push += fromBullet(normal * impulse + (targetIsB ? friction : -friction));
        if (point.getDistance() < touch.distance) {
            touch.distance = point.getDistance();
            const btVector3& position = targetIsB ? point.getPositionWorldOnB() : point.getPositionWorldOnA();
            const int triangle = targetIsB ? point.m_index1 : point.m_index0;
            touch.deepest = {fromBullet(position), fromBullet(normal), triangle};
        }
    }
}

void add(Touch& touch, const Touch& other) {
    touch.push += other.push;
    if (other.distance < touch.distance) {
        touch.distance = other.distance;
        touch.deepest = other.deepest;
    }
}

bool isSamePair(const TouchEntry& a, const TouchEntry& b) {
    return a.projectile == b.projectile && a.target == b.target;
}

/// Those of one pair become one, in the order in which they are.
void mergePairs(std::vector<TouchEntry>& entries) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (kept > 0 && isSamePair(entries[kept - 1], entries[i])) {
            add(entries[kept - 1].touch, entries[i].touch);
        } else {
            entries[kept++] = entries[i];
        }
    }
    entries.resize(kept);
}

}  // namespace

void collectTouches(btDispatcher& dispatcher, std::vector<TouchEntry>& result) {
    result.clear();
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
        const float near =
            kTouchDistance * static_cast<const btSphereShape*>(projectile->getCollisionShape())->getRadius();
        Touch touch;
        add(touch, manifold, targetIsB, near);
        if (touch.push != glm::vec3(0.0f) || touch.distance <= near) {
            result.push_back({{static_cast<std::uint32_t>(projectile->getUserIndex2())},
                              {static_cast<std::uint32_t>(target->getUserIndex2())},
                              touch});
        }
    }
    std::stable_sort(result.begin(), result.end(), [](const TouchEntry& a, const TouchEntry& b) {
        return a.projectile != b.projectile ? a.projectile < b.projectile : a.target < b.target;
    });
    mergePairs(result);
}

}  // namespace hitscope::physics
