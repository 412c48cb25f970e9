// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>

#include <glm/vec3.hpp>
#include <optional>

namespace hitscope::physics {

/// The first body that a moving sphere meets.
struct SweepContact {
    const btCollisionObject* body = nullptr;
    float fraction = 1.0f;  ///< of the motion, [0, 1]
    int triangle = -1;      ///< of a mesh; -1: not a mesh
};

/// Sweeps `self`'s sphere of `radius` along `motion` (metres) from `from`, which it has not left yet. Bodies
/// that it moves away from are passed over. Bullet's convex cast decides; the centre's own ray backs it,
/// because an iterative cast may give up on a long motion while a ray through a triangle cannot.
[[nodiscard]] std::optional<SweepContact> sweep(const btCollisionWorld& world, const btCollisionObject& self,
                                                const btSphereShape& sphere, const glm::vec3& from,
                                                const glm::vec3& motion);

/// The first target or floor between two points; projectiles are passed over.
struct LineContact {
    const btCollisionObject* body = nullptr;
    float fraction = 1.0f;   ///< of the line, [0, 1]
    glm::vec3 normal{0.0f};  ///< unit, world, towards the line's start
    int triangle = -1;       ///< of a mesh; -1: not a mesh
};
[[nodiscard]] std::optional<LineContact> castLine(const btCollisionWorld& world, const glm::vec3& from,
                                                  const glm::vec3& to);

}  // namespace hitscope::physics
