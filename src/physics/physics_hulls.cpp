// SPDX-License-Identifier: GPL-3.0-or-later
// The hulls by which targets meet each other, and what lies on a target.
#include <LinearMath/btAabbUtil2.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "physics/world_private.h"

namespace hitscope {

using namespace physics;

namespace {

// Metres, around a box: Bullet's broadphase pairs up what is some 0.1 apart, and then hulls are compared.
constexpr btScalar kHullReach = 0.25f;

struct Box {
    btVector3 low;
    btVector3 high;

    explicit Box(const btCollisionObject& body) {
        body.getCollisionShape()->getAabb(body.getWorldTransform(), low, high);
    }
    [[nodiscard]] bool meets(const Box& other) const {
        return TestAabbAgainstAabb2(low, high, other.low, other.high);
    }
};

/// Before and after a step of so many seconds.
std::vector<Box> boxesOfDynamics(const std::map<TargetId, TargetBody>& targets, double step) {
    std::vector<Box> boxes;
    for (const auto& [id, target] : targets) {
        if (target.physics.isDynamic) {
            const btScalar way = target.body->getLinearVelocity().length() * static_cast<btScalar>(step);
            const btVector3 around = btVector3(1, 1, 1) * (2.0f * way + kHullReach);
            Box& box = boxes.emplace_back(*target.body);
            box.low -= around;
            box.high += around;
        }
    }
    return boxes;
}

/// Wakes dynamic targets whose boxes meet one.
struct Wake : btBroadphaseAabbCallback {
    btVector3 low;
    btVector3 high;

    explicit Wake(const btBroadphaseProxy& box) : low(box.m_aabbMin), high(box.m_aabbMax) {}
    bool process(const btBroadphaseProxy* proxy) override {
        auto& body = *static_cast<btCollisionObject*>(proxy->m_clientObject);
        if (isKind(body, BodyKind::Target) && !body.isStaticObject() &&
            TestAabbAgainstAabb2(proxy->m_aabbMin, proxy->m_aabbMax, low, high)) {  // leaves are larger
            body.activate();
        }
        return true;
    }
};

}  // namespace

/// Once a step, however many hits there were. Hulls meet hulls of dynamic targets only: one that none of
/// these comes near needs none.
void PhysicsWorld::Private::followHulls() {
    const std::vector<Box> boxes = boxesOfDynamics(targets, clock.step());
    if (boxes.empty()) {
        return;
    }
    for (auto& [id, target] : targets) {
        if (!target.hullIsOld) {
            continue;
        }
        const Box own(*target.body);
        const bool isNear =
            std::any_of(boxes.begin(), boxes.end(), [&own](const Box& box) { return box.meets(own); });
        if (isNear && std::exchange(target.hullIsOld, false) && target.shape->followSurface()) {
            broadphase.getOverlappingPairCache()->cleanProxyFromPairs(target.body->getBroadphaseProxy(),
                                                                      &dispatcher);
        }
    }
}

/// What lies on it, or leans against it, may have lost its hold.
void PhysicsWorld::Private::wakeWhatTouches(TargetId id, const TargetBody& target) {
    for (auto& [flightId, flight] : flights) {
        if (flight.touches(id)) {
            flight.body->activate(true);
        }
    }
    // Bullet's own box is that of the last step: a dent that has just been made is not in it yet.
    Wake wake(*target.body->getBroadphaseProxy());
    broadphase.aabbTest(wake.low, wake.high, wake);
}

}  // namespace hitscope
