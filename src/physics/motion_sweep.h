// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "core/ids.h"
#include "physics/collision_shape.h"

namespace hitscope::physics {

/// What a body of the world is; kept in Bullet's first user index. A target's id or a projectile's is in the
/// second.
enum class BodyKind : int { Target = 1, Floor = 2, Projectile = 3 };
[[nodiscard]] bool isKind(const btCollisionObject& body, BodyKind kind);

/// The first thing that a moving sphere meets.
struct SweepContact {
    TargetId target;        ///< 0: the floor
    double fraction = 1.0;  ///< of the motion, [0, 1]
    int triangle = -1;      ///< of a mesh; -1: not a mesh
};

/// All targets and the floor, as they stand at one moment. A list without a tree: for thousands of spheres a
/// step, comparing boxes with a hundred targets beats Bullet's broadphase, which the spheres are in too.
class SweepScene {
public:
    void clear();
    /// `shape` outlives this or the next clear().
    void addTarget(TargetId target, const btTransform& where, const CollisionShape& shape);
    void setFloor(float height) { m_floor = static_cast<double>(height); }

    /// Sweeps a sphere of `radius` metres (0: a point) along `motion` from `from`. What it moves away from is
    /// passed over. Exact for every shape there is, at any length.
    [[nodiscard]] std::optional<SweepContact> sweep(const glm::vec3& from, const glm::vec3& motion,
                                                    float radius) const;

private:
    struct Entry {
        TargetId target;
        const CollisionShape* shape;
        Bounds box;          ///< world
        glm::dvec3 rows[3];  ///< of the rotation from local to world
        glm::dvec3 origin;   ///< of Bullet's frame, world
        glm::dvec3 centre;   ///< the same, local

        [[nodiscard]] glm::dvec3 directionToLocal(const glm::dvec3& world) const;
    };

    std::vector<Entry> m_entries;
    std::optional<double> m_floor;
};

}  // namespace hitscope::physics
