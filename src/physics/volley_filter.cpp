// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/volley_filter.h"

#include "physics/motion_sweep.h"

namespace hitscope::physics {
namespace {

const btCollisionObject& bodyOf(const btBroadphaseProxy& proxy) {
    return *static_cast<const btCollisionObject*>(proxy.m_clientObject);
}

bool passEachOther(int a, int b) {
    return a == VolleyFilter::kPassesAll || b == VolleyFilter::kPassesAll || (a > 0 && a == b);
}

}  // namespace

bool VolleyFilter::needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const {
    if ((a->m_collisionFilterGroup & b->m_collisionFilterMask) == 0 ||
        (b->m_collisionFilterGroup & a->m_collisionFilterMask) == 0) {
        return false;
    }
    const btCollisionObject& one = bodyOf(*a);
    const btCollisionObject& other = bodyOf(*b);
    return !isKind(one, BodyKind::Projectile) || !isKind(other, BodyKind::Projectile) ||
           !passEachOther(one.getUserIndex3(), other.getUserIndex3());
}

}  // namespace hitscope::physics
