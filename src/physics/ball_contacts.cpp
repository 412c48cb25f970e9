// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/ball_contacts.h"

#include <BulletCollision/CollisionDispatch/btActivatingCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>

#include "physics/contact_creation.h"

namespace hitscope::physics {
namespace {

btScalar radiusOf(const btCollisionObjectWrapper& body) {
    return static_cast<const btSphereShape*>(body.getCollisionShape())->getRadius();
}

class BallBall : public btActivatingCollisionAlgorithm {
public:
    BallBall(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* a,
             const btCollisionObjectWrapper* b)
        : btActivatingCollisionAlgorithm(info, a, b) {}
    ~BallBall() override { release(); }
    BallBall(const BallBall&) = delete;
    BallBall& operator=(const BallBall&) = delete;

    void processCollision(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                          const btDispatcherInfo& /*info*/, btManifoldResult* result) override {
        const btVector3 apart = a->getWorldTransform().getOrigin() - b->getWorldTransform().getOrigin();
        const btScalar reach = radiusOf(*a) + radiusOf(*b);
        const btScalar distance2 = apart.length2();
        if (distance2 > reach * reach) {
            release();
            return;
        }
        if (m_manifold == nullptr) {
            m_manifold = m_dispatcher->getNewManifold(a->getCollisionObject(), b->getCollisionObject());
        }
        m_manifold->clearManifold();
        result->setPersistentManifold(m_manifold);
        const btScalar distance = btSqrt(distance2);
        const btVector3 normal = distance > SIMD_EPSILON ? apart / distance : btVector3(1, 0, 0);
        const btVector3 point = b->getWorldTransform().getOrigin() + normal * radiusOf(*b);
        result->addContactPoint(normal, point, distance - reach);
    }

    /// Bullet does not ask: its own continuous collision detection is off (see stepped_world.h).
    btScalar calculateTimeOfImpact(btCollisionObject* /*a*/, btCollisionObject* /*b*/,
                                   const btDispatcherInfo& /*info*/, btManifoldResult* /*result*/) override {
        return 1.0f;
    }
    void getAllContactManifolds(btManifoldArray& manifolds) override {
        if (m_manifold != nullptr) {
            manifolds.push_back(m_manifold);
        }
    }

private:
    void release() {
        if (m_manifold != nullptr) {
            m_dispatcher->releaseManifold(m_manifold);
            m_manifold = nullptr;
        }
    }

    btPersistentManifold* m_manifold = nullptr;  ///< null: they do not touch
};

}  // namespace

BallContacts::BallContacts(btCollisionDispatcher& dispatcher)
    : m_create(std::make_unique<ContactCreation<BallBall>>()) {
    dispatcher.registerCollisionCreateFunc(SPHERE_SHAPE_PROXYTYPE, SPHERE_SHAPE_PROXYTYPE, m_create.get());
}

}  // namespace hitscope::physics
