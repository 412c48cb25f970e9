// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/motion_sweep.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "physics/bullet_conversions.h"

namespace hitscope::physics {
namespace {

class SphereCallback : public btCollisionWorld::ConvexResultCallback {
public:
    SphereCallback(const btCollisionObject& self, const btVector3& motion)
        : m_self(&self), m_motion(motion) {}

    bool needsCollision(btBroadphaseProxy* proxy) const override {
        return proxy->m_clientObject != m_self && ConvexResultCallback::needsCollision(proxy);
    }

    btScalar addSingleResult(btCollisionWorld::LocalConvexResult& result, bool worldNormal) override {
        const btCollisionObject* body = result.m_hitCollisionObject;
        const btVector3 normal = worldNormal ? result.m_hitNormalLocal
                                             : body->getWorldTransform().getBasis() * result.m_hitNormalLocal;
        if (normal.dot(m_motion) >= 0.0f || result.m_hitFraction > m_contact.fraction) {
            return m_closestHitFraction;
        }
        m_closestHitFraction = result.m_hitFraction;
        m_contact.body = body;
        m_contact.fraction = result.m_hitFraction;
        m_contact.triangle =
            result.m_localShapeInfo != nullptr ? result.m_localShapeInfo->m_triangleIndex : -1;
        return result.m_hitFraction;
    }

    [[nodiscard]] const SweepContact& contact() const { return m_contact; }

private:
    const btCollisionObject* m_self;
    btVector3 m_motion;
    SweepContact m_contact;
};

class LineCallback : public btCollisionWorld::RayResultCallback {
public:
    /// `self` is passed over; null: nothing is.
    explicit LineCallback(const btCollisionObject* self) : m_self(self) {}

    bool needsCollision(btBroadphaseProxy* proxy) const override {
        return proxy->m_clientObject != m_self && RayResultCallback::needsCollision(proxy);
    }

    btScalar addSingleResult(btCollisionWorld::LocalRayResult& result, bool worldNormal) override {
        const btCollisionObject* body = result.m_collisionObject;
        m_closestHitFraction = result.m_hitFraction;
        m_collisionObject = body;
        m_normal = worldNormal ? result.m_hitNormalLocal
                               : body->getWorldTransform().getBasis() * result.m_hitNormalLocal;
        m_triangle = result.m_localShapeInfo != nullptr ? result.m_localShapeInfo->m_triangleIndex : -1;
        return result.m_hitFraction;
    }

    [[nodiscard]] std::optional<LineContact> contact() const {
        if (!hasHit()) {
            return std::nullopt;
        }
        return LineContact{m_collisionObject, m_closestHitFraction, fromBullet(m_normal.normalized()),
                           m_triangle};
    }

private:
    const btCollisionObject* m_self;
    btVector3 m_normal{0, 1, 0};
    int m_triangle = -1;
};

}  // namespace

std::optional<SweepContact> sweep(const btCollisionWorld& world, const btCollisionObject& self,
                                  const btSphereShape& sphere, const glm::vec3& from,
                                  const glm::vec3& motion) {
    const btVector3 start = toBullet(from);
    const btVector3 end = start + toBullet(motion);
    SphereCallback swept(self, toBullet(motion));
    world.convexSweepTest(&sphere, btTransform(btQuaternion::getIdentity(), start),
                          btTransform(btQuaternion::getIdentity(), end), swept);

    LineCallback line(&self);
    world.rayTest(start, end, line);
    const auto centre = line.contact();
    if (centre && centre->fraction < swept.contact().fraction) {
        // The sphere touched the surface before its centre crossed it.
        const float approach = std::max(-glm::dot(centre->normal, motion), 1.0e-6f);
        const float fraction = std::max(0.0f, centre->fraction - sphere.getRadius() / approach);
        return SweepContact{centre->body, fraction, centre->triangle};
    }
    if (swept.contact().body != nullptr) {
        return swept.contact();
    }
    return std::nullopt;
}

std::optional<LineContact> castLine(const btCollisionWorld& world, const glm::vec3& from,
                                    const glm::vec3& to) {
    LineCallback line(nullptr);
    line.m_collisionFilterMask = btBroadphaseProxy::StaticFilter;
    world.rayTest(toBullet(from), toBullet(to), line);
    return line.contact();
}

}  // namespace hitscope::physics
