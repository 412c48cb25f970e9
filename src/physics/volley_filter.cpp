// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/volley_filter.h"

#include "physics/motion_sweep.h"

namespace hitscope::physics {
namespace {

int volleyOf(const btBroadphaseProxy& proxy) {
    const auto* body = static_cast<const btCollisionObject*>(proxy.m_clientObject);
    return isKind(*body, BodyKind::Projectile) ? body->getUserIndex3() : 0;
}

}  // namespace

bool VolleyFilter::needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const {
    if ((a->m_collisionFilterGroup & b->m_collisionFilterMask) == 0 ||
        (b->m_collisionFilterGroup & a->m_collisionFilterMask) == 0) {
        return false;
    }
    const int volley = volleyOf(*a);
    return volley <= 0 || volley != volleyOf(*b);
}

}  // namespace hitscope::physics
