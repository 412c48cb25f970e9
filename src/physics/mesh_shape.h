// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletCollision/CollisionShapes/btConcaveShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>

#include <memory>

#include "physics/mesh_surface.h"

namespace hitscope::physics {

/// Bullet's view of a MeshSurface: spheres meet its triangles, everything else its convex hull (see
/// mesh_contacts.h). Its frame's origin is the surface's `centre`, since Bullet turns bodies about it.
class MeshShape : public btConcaveShape {
public:
    /// `centre`: metres, local frame.
    MeshShape(std::shared_ptr<const CollisionMesh> original, const glm::vec3& centre);

    MeshSurface& surface() { return m_surface; }
    [[nodiscard]] const MeshSurface& surface() const { return m_surface; }
    [[nodiscard]] const glm::vec3& centre() const { return m_centre; }
    /// Of the original shape: a dent does not change how a target tumbles.
    [[nodiscard]] const btConvexHullShape& hull() const { return m_hull; }

    void getAabb(const btTransform& transform, btVector3& low, btVector3& high) const override;
    void processAllTriangles(btTriangleCallback* callback, const btVector3& low,
                             const btVector3& high) const override;
    void setLocalScaling(const btVector3& scaling) override;  ///< there is none: targets are rigid
    [[nodiscard]] const btVector3& getLocalScaling() const override;
    void calculateLocalInertia(btScalar mass, btVector3& inertia) const override;  ///< the hull's
    [[nodiscard]] const char* getName() const override { return "MeshShape"; }

private:
    MeshSurface m_surface;
    glm::vec3 m_centre;
    btConvexHullShape m_hull;
};

}  // namespace hitscope::physics
