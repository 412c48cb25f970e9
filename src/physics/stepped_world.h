// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <btBulletDynamicsCommon.h>

#include "physics/motion_sweep.h"

namespace hitscope::physics {

/// Bullet's world with a sweep of ours in place of its continuous collision detection: projectiles that move
/// far in a step stop at the first surface they meet, be it after a bounce in the same step. Bullet's own
/// casts try every triangle in the box around the whole motion. Two fast projectiles may pass each other.
class SteppedWorld : public btDiscreteDynamicsWorld {
public:
    /// `scene` outlives this and is current whenever a step is made.
    SteppedWorld(btDispatcher& dispatcher, btBroadphaseInterface& broadphase, btConstraintSolver& solver,
                 btCollisionConfiguration& configuration, const SweepScene& scene)
        : btDiscreteDynamicsWorld(&dispatcher, &broadphase, &solver, &configuration), m_scene(scene) {}

protected:
    void integrateTransforms(btScalar seconds) override;

private:
    const SweepScene& m_scene;
};

}  // namespace hitscope::physics
