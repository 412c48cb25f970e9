// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <variant>

#include "physics/collision_mesh.h"

namespace hitscope {

/// Where a target is: rigid, since scale is baked into the vertices when a mesh is loaded.
struct RigidTransform {
    glm::vec3 position{0.0f};                    ///< metres, world
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};  ///< unit

    [[nodiscard]] glm::vec3 toWorld(const glm::vec3& localPoint) const {
        return rotation * localPoint + position;
    }
    [[nodiscard]] glm::vec3 toLocal(const glm::vec3& worldPoint) const {
        return glm::conjugate(rotation) * (worldPoint - position);
    }
    [[nodiscard]] glm::vec3 directionToLocal(const glm::vec3& world) const {
        return glm::conjugate(rotation) * world;
    }
    [[nodiscard]] glm::vec3 directionToWorld(const glm::vec3& local) const { return rotation * local; }
    /// From local to world.
    [[nodiscard]] glm::mat4 matrix() const {
        glm::mat4 matrix = glm::mat4_cast(rotation);
        matrix[3] = glm::vec4(position, 1.0f);
        return matrix;
    }

    bool operator==(const RigidTransform&) const = default;
};

/// Colliders, about the target's local origin. A primitive is exact until its first dent: from then on its
/// `surface` is what is hit, where it has one.
struct BoxCollider {
    glm::vec3 halfExtent{0.5f};  ///< metres
    std::shared_ptr<const CollisionMesh> surface{};
};
struct SphereCollider {
    float radius = 0.5f;  ///< metres
    std::shared_ptr<const CollisionMesh> surface{};
};
struct MeshCollider {
    std::shared_ptr<const CollisionMesh> surface{};
};
using Collider = std::variant<BoxCollider, SphereCollider, MeshCollider>;

}  // namespace hitscope
