// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionCreateFunc.h>

namespace hitscope::physics {

/// How Bullet's dispatcher makes an `Algorithm` of ours for two bodies: in its own pool, which also frees it.
template <class Algorithm>
struct ContactCreation : btCollisionAlgorithmCreateFunc {
    btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                   const btCollisionObjectWrapper* a,
                                                   const btCollisionObjectWrapper* b) override {
        void* place = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(Algorithm));
        return new (place) Algorithm(info, a, b);
    }
};

}  // namespace hitscope::physics
