// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <BulletCollision/CollisionShapes/btTriangleIndexVertexArray.h>

#include <memory>
#include <optional>

#include "physics/physics_world.h"

namespace hitscope::physics {

/// A point of a target's surface and the direction from there to whoever asked.
struct SurfacePoint {
    glm::vec3 point{0.0f};   ///< metres
    glm::vec3 normal{0.0f};  ///< unit, towards the projectile
};

/// Bullet's shape for a collider, with the arrays that a mesh shape points into.
class CollisionShape {
public:
    /// Nothing when the collider has no surface: no usable triangle, or a size that is zero or not finite.
    [[nodiscard]] static std::unique_ptr<CollisionShape> make(const Collider& collider);

    [[nodiscard]] btCollisionShape* bullet() const { return m_shape.get(); }

    /// The point of the surface nearest to `from` (metres, local frame). For a mesh: on `triangle`, an index
    /// as Bullet reports it; nothing when there is none such.
    [[nodiscard]] std::optional<SurfacePoint> nearest(const glm::vec3& from, int triangle) const;

private:
    explicit CollisionShape(const Collider& collider);
    void makeMesh(const MeshCollider& mesh);

    std::variant<BoxCollider, SphereCollider, MeshCollider> m_collider;  ///< a mesh: usable triangles only
    std::unique_ptr<btTriangleIndexVertexArray> m_arrays;
    std::unique_ptr<btCollisionShape> m_shape;
};

}  // namespace hitscope::physics
