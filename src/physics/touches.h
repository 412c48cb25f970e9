// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>

#include <utility>
#include <vector>

#include "core/ids.h"
#include "physics/motion_sweep.h"

namespace hitscope::physics {

/// A projectile in contact with a target after a step, over all of Bullet's manifolds between the two.
struct Touch {
    glm::vec3 push{0.0f};  ///< newton seconds, of the target on the projectile, friction too; world
    SurfacePoint deepest;  ///< world
    float distance =
        std::numeric_limits<float>::max();  ///< metres, of the deepest point; below zero: they overlap
};

struct TouchEntry {
    ProjectileId projectile;
    TargetId target;
    Touch touch;
};

/// The step's contacts into `result`, one a projectile and target, sorted by these two.
void collectTouches(btDispatcher& dispatcher, std::vector<TouchEntry>& result);

}  // namespace hitscope::physics
