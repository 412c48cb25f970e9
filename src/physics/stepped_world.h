// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <btBulletDynamicsCommon.h>

#include <vector>

#include "core/time_limit.h"
#include "physics/motion_sweep.h"

namespace hitscope::physics {

/// Bullet's world with a sweep of ours in place of its continuous collision detection: projectiles that move
/// far in a step stop at the first surface they meet, be it after a bounce in the same step. Bullet's own
/// casts try every triangle in the box around the whole motion. Two fast projectiles may pass each other.
class SteppedWorld : public btDiscreteDynamicsWorld {
public:
    /// `scene` outlives this and is current from the beginning of a step to the end of its motion.
    SteppedWorld(btDispatcher& dispatcher, btBroadphaseInterface& broadphase, btConstraintSolver& solver,
                 btCollisionConfiguration& configuration, const SweepScene& scene)
        : btDiscreteDynamicsWorld(&dispatcher, &broadphase, &solver, &configuration), m_scene(scene) {}

    /// stepSimulation() solves and leaves each body where it was: this moves them, one after the other,
    /// until time is up. Returns whether all have moved. No body is added or removed before.
    bool move(const IsTimeUp& isTimeUp);

protected:
    void integrateTransforms(btScalar seconds) override;

private:
    const SweepScene& m_scene;
    std::vector<btRigidBody*> m_toMove;  ///< the last first
    btScalar m_seconds = 0;
};

}  // namespace hitscope::physics
