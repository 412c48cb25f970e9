// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletCollision/CollisionShapes/btConcaveShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>

#include <memory>
#include <vector>

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
    /// Of the surface at the last followSurface(), of the original one before the first.
    [[nodiscard]] const btConvexHullShape& hull() const { return *m_hull; }
    /// Returns whether the hull became another one: contacts that Bullet keeps of the old one are void then.
    bool followSurface();

    void getAabb(const btTransform& transform, btVector3& low, btVector3& high) const override;
    void processAllTriangles(btTriangleCallback* callback, const btVector3& low,
                             const btVector3& high) const override;
    void setLocalScaling(const btVector3& scaling) override;  ///< there is none: targets are rigid
    [[nodiscard]] const btVector3& getLocalScaling() const override;
    /// The original hull's: a dent moves no mass to speak of.
    void calculateLocalInertia(btScalar mass, btVector3& inertia) const override;
    [[nodiscard]] const char* getName() const override { return "MeshShape"; }

private:
    void makeHull(std::vector<glm::vec3> points);

    MeshSurface m_surface;
    glm::vec3 m_centre;
    Outermost m_outermost;
    std::vector<glm::vec3> m_hullPoints;  ///< those of m_hull, local frame
    std::unique_ptr<btConvexHullShape> m_hull;
    btVector3 m_inertia{0, 0, 0};  ///< of 1 kg
};

}  // namespace hitscope::physics
