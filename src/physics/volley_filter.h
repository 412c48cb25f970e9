// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletCollision/BroadphaseCollision/btOverlappingPairCache.h>

namespace hitscope::physics {

/// Bullet's usual filter, except that projectiles of one volley pass through each other: they may leave from
/// one point. A body's volley is in its third user index; 0: none; kPassesAll: it passes through all others.
class VolleyFilter : public btOverlapFilterCallback {
public:
    static constexpr int kPassesAll = -1;

    [[nodiscard]] bool needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const override;
};

}  // namespace hitscope::physics
