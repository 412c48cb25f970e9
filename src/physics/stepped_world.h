// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <btBulletDynamicsCommon.h>

namespace hitscope::physics {

/// Bullet's world with a sweep of ours in place of its continuous collision detection: projectiles that move
/// far in a step stop at the first thing they meet, be it after a bounce in the same step. Bullet's own casts
/// try every triangle in the box around the whole motion.
class SteppedWorld : public btDiscreteDynamicsWorld {
public:
    using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;

protected:
    void integrateTransforms(btScalar seconds) override;
};

}  // namespace hitscope::physics
