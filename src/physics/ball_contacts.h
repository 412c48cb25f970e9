// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionCreateFunc.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>

#include <memory>

namespace hitscope::physics {

/// Contacts of spheres with spheres, in place of Bullet's own, which keeps a manifold for every two spheres
/// whose boxes overlap: thousands of projectiles that fly close to each other would fill the world with empty
/// ones, and every step goes through them all. Here only those that touch have one.
class BallContacts {
public:
    /// Registers itself; outlives all of the dispatcher's pairs.
    explicit BallContacts(btCollisionDispatcher& dispatcher);

private:
    std::unique_ptr<btCollisionAlgorithmCreateFunc> m_create;
};

}  // namespace hitscope::physics
