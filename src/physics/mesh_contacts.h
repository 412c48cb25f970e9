// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>

#include <memory>

namespace hitscope::physics {

/// How a MeshShape touches other shapes. A sphere: where its centre is nearest to the triangles, at most a
/// few contacts whatever the mesh's resolution. Anything else: by the mesh's convex hull, so two targets meet
/// as hulls, and the floor carries the hull.
class MeshContacts {
public:
    /// `dispatcher` does not outlive this.
    explicit MeshContacts(btCollisionDispatcher& dispatcher);
    ~MeshContacts();
    MeshContacts(const MeshContacts&) = delete;
    MeshContacts& operator=(const MeshContacts&) = delete;

private:
    std::unique_ptr<btCollisionAlgorithmCreateFunc> m_sphere;
    std::unique_ptr<btCollisionAlgorithmCreateFunc> m_hull;
};

}  // namespace hitscope::physics
