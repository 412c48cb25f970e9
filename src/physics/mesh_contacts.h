// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

namespace hitscope::physics {

/// Where a sphere touches a mesh.
struct MeshContact {
    glm::dvec3 point;   ///< on the mesh, local frame, metres
    glm::dvec3 normal;  ///< unit, towards the sphere's centre
    double distance;    ///< of the centre
    std::uint32_t triangle;
};

/// The contacts of a sphere with one mesh, worked out before Bullet asks.
struct ContactsAhead {
    const btCollisionObject* mesh;
    glm::dvec3 centre;  ///< of the sphere, in the mesh's local frame
    double reach;       ///< within which contacts were looked for
    std::vector<MeshContact> contacts;
};

/// Adds what `ball` touches of `mesh` where both now are. A sphere whose user pointer is `ahead` (a
/// std::vector<ContactsAhead>) is then spared the search in Bullet's next step, unless it has moved. Nothing
/// when `mesh` is no MeshShape, or is not near.
void workOutContacts(const btCollisionObject& ball, const btCollisionObject& mesh,
                     std::vector<ContactsAhead>& ahead);

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
