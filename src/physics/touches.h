// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>

#include <map>
#include <utility>

#include "core/ids.h"
#include "physics/motion_sweep.h"

namespace hitscope::physics {

/// A projectile in contact with a target after a step, over all of Bullet's manifolds between the two.
struct Touch {
    float impulse = 0.0f;   ///< newton seconds, along the normals
    SurfacePoint deepest;   ///< world
    float distance = 1.0f;  ///< metres, of the deepest point; below zero: they overlap
};

using TouchKey = std::pair<ProjectileId, TargetId>;

/// The step's contacts, in an order that depends on ids alone.
[[nodiscard]] std::map<TouchKey, Touch> touches(btDispatcher& dispatcher);

}  // namespace hitscope::physics
