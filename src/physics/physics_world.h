// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "core/ids.h"
#include "core/parameter.h"
#include "mesh/mesh_data.h"

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
};

/// Colliders, about the target's local origin.
struct BoxCollider {
    glm::vec3 halfExtent{0.5f};  ///< metres
};
struct SphereCollider {
    float radius = 0.5f;  ///< metres
};
struct MeshCollider {
    std::vector<glm::vec3> vertices;       ///< metres, local frame
    std::vector<std::uint32_t> triangles;  ///< 3 a triangle; two-sided
};
using Collider = std::variant<BoxCollider, SphereCollider, MeshCollider>;

/// How projectiles are shot. The defaults are the paper's reference scene.
struct ProjectileSettings {
    float radius = 0.1f;        ///< metres
    float mass = 1.0f;          ///< kilograms
    float speed = 30.0f;        ///< m/s
    float lifetime = 5.0f;      ///< seconds after which a projectile disappears
    bool bouncesCount = false;  ///< false: one flight makes one hit at most
};

/// A live projectile, for drawing.
struct ProjectileState {
    ProjectileId id;
    glm::vec3 position{0.0f};  ///< metres, world
    float radius = 0.1f;       ///< metres
};

/// A projectile struck a target, as Bullet reports it.
struct Impact {
    TargetId target;
    ProjectileId projectile;
    glm::vec3 point{0.0f};      ///< metres, world: the contact point on the target
    glm::vec3 direction{0.0f};  ///< unit, world: the projectile's velocity direction just before impact
    glm::vec3 normal{0.0f};     ///< unit, world: the target's surface normal there, towards the projectile
    float speed = 0.0f;         ///< m/s, just before impact
    float impulse = 0.0f;       ///< newton seconds
    double time = 0.0;          ///< seconds of simulated time, end of the step
};

/// The Bullet world: static targets, a floor, projectiles. Deterministic: the same calls give the same
/// impacts.
class PhysicsWorld {
public:
    PhysicsWorld();
    ~PhysicsWorld();
    PhysicsWorld(const PhysicsWorld&) = delete;
    PhysicsWorld& operator=(const PhysicsWorld&) = delete;

    /// Replaces the target of that id, if there is one. A collider without surface (no usable triangle, a
    /// size that is zero or not finite) cannot be hit; triangles without area or with indices out of range
    /// are left out.
    void addTarget(TargetId target, const RigidTransform& transform, const Collider& collider);
    void removeTarget(TargetId target);
    /// An endless horizontal floor at height y metres; projectiles rest on it, it takes no hits.
    void setFloor(float y);
    void removeFloor();

    /// Launches a projectile from `origin` (metres, world) along `direction` (unit). It never tunnels.
    /// Settings out of range are clamped. Nothing is launched, and id 0 comes back, when origin or direction
    /// is not finite or the direction is zero.
    ProjectileId shoot(const glm::vec3& origin, const glm::vec3& direction,
                       const ProjectileSettings& settings);
    void removeProjectiles();

    /// Advances by `seconds` in fixed steps of kStep (a remainder waits for the next call; at most kMaxSteps
    /// a call, the rest of the time is dropped so that a slow frame cannot snowball). Returns the impacts in
    /// the order they happened.
    [[nodiscard]] std::vector<Impact> advance(double seconds);

    [[nodiscard]] std::vector<ProjectileState> projectiles() const;
    [[nodiscard]] std::size_t projectileCount() const;
    /// Seconds simulated so far.
    [[nodiscard]] double time() const;

    /// First target a straight line meets, without shooting: for aiming and recentring.
    struct RayHit {
        TargetId target;  ///< 0: the floor
        glm::vec3 point{0.0f};
        glm::vec3 normal{0.0f};
    };
    /// Nothing when the ray meets neither target nor floor within `length` metres. `direction` is unit.
    [[nodiscard]] std::optional<RayHit> castRay(const glm::vec3& origin, const glm::vec3& direction,
                                                float length) const;

    static constexpr double kStep = 1.0 / 240.0;  ///< seconds
    static constexpr float kGravity = 9.81f;      ///< m/s^2, downwards along y
    static constexpr int kMaxSteps = 60;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

}  // namespace hitscope
