// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>

#include <glm/vec3.hpp>
#include <optional>

#include "physics/collision_shape.h"

namespace hitscope::physics {

/// What a body of the world is; kept in Bullet's first user index. A target's id or a projectile's is in the
/// second, a target's CollisionShape behind the user pointer.
enum class BodyKind : int { Target = 1, Floor = 2, Projectile = 3 };
[[nodiscard]] bool isKind(const btCollisionObject& body, BodyKind kind);

/// Where targets are in the local frame of a body, in double.
struct LocalFrame {
    explicit LocalFrame(const btCollisionObject& body, const CollisionShape& shape);
    [[nodiscard]] glm::dvec3 toLocal(const glm::dvec3& world) const;
    [[nodiscard]] glm::dvec3 directionToLocal(const glm::dvec3& world) const;

    glm::dvec3 rows[3];  ///< of the rotation from local to world
    glm::dvec3 origin;
    glm::dvec3 centre;
};

/// The first body that a moving sphere meets.
struct SweepContact {
    const btCollisionObject* body = nullptr;
    double fraction = 1.0;  ///< of the motion, [0, 1]
    int triangle = -1;      ///< of a mesh; -1: not a mesh
};

enum class Meets { Targets, All };  ///< targets and floor; projectiles too

/// Sweeps a sphere of `radius` metres (0: a point) along `motion` from `from`; `self` is passed over, and so
/// are bodies that it moves away from. Exact for every shape there is, at any length.
[[nodiscard]] std::optional<SweepContact> sweep(btBroadphaseInterface& broadphase,
                                                const btCollisionObject* self, Meets meets,
                                                const glm::vec3& from, const glm::vec3& motion, float radius);

}  // namespace hitscope::physics
