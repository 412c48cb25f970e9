// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include <memory>
#include <optional>
#include <span>

#include "core/result.h"
#include "physics/collider.h"
#include "physics/mesh_shape.h"

namespace hitscope::physics {

/// A point of a target's surface and the direction from there to whoever asked.
struct SurfacePoint {
    glm::vec3 point{0.0f};   ///< metres
    glm::vec3 normal{0.0f};  ///< unit, towards the projectile
    int triangle = -1;       ///< -1: not a mesh
};

/// A target's collider as it is now: exact while it is an unhurt primitive, else its triangles.
class CollisionShape {
public:
    /// An error when the collider has no surface: no triangle with an area, a size that is zero, not finite
    /// or too large.
    [[nodiscard]] static Result<std::unique_ptr<CollisionShape>> make(const Collider& collider);

    /// Another one that is now the same.
    [[nodiscard]] std::unique_ptr<CollisionShape> copy() const;

    /// What Bullet shall collide with; another one after update() or reset() said so.
    [[nodiscard]] btCollisionShape* bullet() const;
    /// The origin of Bullet's frame in the local one; the body turns about it.
    [[nodiscard]] const glm::vec3& centre() const { return m_centre; }
    [[nodiscard]] Bounds bounds() const;  ///< local frame

    struct Change {
        bool moved = false;      ///< a vertex is not where it was
        bool isAnother = false;  ///< bullet() is another one
    };
    /// The mesh's vertices [first, first + vertices.size()) are now there.
    Change update(std::uint32_t first, std::span<const DynamicVertex> vertices);
    Change reset();
    /// What the floor and other targets meet follows the mesh. Returns whether it became another one.
    bool followSurface() { return m_mesh && m_mesh->followSurface(); }

    /// First contact of a sphere, `radius` 0: of a point; local frame.
    [[nodiscard]] std::optional<SurfaceCast> cast(const glm::dvec3& start, const glm::dvec3& motion,
                                                  double radius) const;
    /// The triangles in boxes within `distance` of `point`, unhurt primitive or not.
    [[nodiscard]] std::vector<std::uint32_t> near(const glm::vec3& point, float distance) const;
    /// The point of the surface nearest to `from` (metres, local frame). For a mesh: on `triangle`; nothing
    /// when there is none such.
    [[nodiscard]] std::optional<SurfacePoint> nearest(const glm::vec3& from, int triangle) const;
    /// Unit; the surface's own side, at `point` on it (of `triangle`, for a mesh).
    [[nodiscard]] glm::vec3 normalAt(const glm::vec3& point, int triangle) const;

private:
    CollisionShape() = default;
    Status takeBox(const BoxCollider& box);
    Status takeSphere(const SphereCollider& sphere);
    Status takeMesh(const MeshCollider& mesh);
    void prepareSurface(const std::shared_ptr<const CollisionMesh>& surface);
    [[nodiscard]] bool usesMesh() const;

    Collider m_collider;
    glm::vec3 m_centre{0.0f};
    std::unique_ptr<btCollisionShape> m_primitive;  ///< null: a mesh from the start
    std::unique_ptr<MeshShape> m_mesh;              ///< null: a primitive that cannot be dented
};

}  // namespace hitscope::physics
