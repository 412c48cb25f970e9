// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/ids.h"
#include "core/result.h"
#include "core/time_limit.h"
#include "mesh/mesh_data.h"
#include "mesh/render_mesh.h"
#include "physics/collider.h"
#include "physics/projectile_settings.h"
#include "physics/step_clock.h"

namespace hitscope {

/// A live projectile, for drawing.
struct ProjectileState {
    ProjectileId id;
    glm::vec3 position{0.0f};  ///< metres, world: after the last step
    glm::vec3 drawn{0.0f};     ///< where to draw it now, between the last two steps
    glm::vec3 velocity{0.0f};  ///< m/s
    float radius = 0.1f;       ///< metres
    glm::vec3 colour{1.0f};    ///< sRGB
    /// Where it has been in the last kTrailSeconds of simulated time, metres, world, oldest first. Valid
    /// until the world changes.
    std::span<const glm::vec3> trail;
};

/// A dynamic target's place.
struct TargetPose {
    TargetId id;
    RigidTransform transform;  ///< after the last step
    RigidTransform drawn;      ///< where to draw it now, between the last two steps
};

/// A projectile struck a target, as Bullet reports it.
struct Impact {
    TargetId target;
    ProjectileId projectile;    ///< 0: an instant shot
    glm::vec3 point{0.0f};      ///< metres, world: the contact point on the target
    glm::vec3 direction{0.0f};  ///< unit, world: the projectile's velocity direction just before impact
    glm::vec3 normal{0.0f};     ///< unit, world: the target's surface normal there, towards the projectile
    RigidTransform where;       ///< of the target at that moment: takes the above to its local frame
    std::uint32_t triangle = kNoIndex;  ///< of the target's mesh; kNoIndex: an undented primitive
    float speed = 0.0f;                 ///< m/s, just before impact
    float impulse = 0.0f;               ///< newton seconds
    double time = 0.0;                  ///< seconds of simulated time, end of the step
    float radius = 0.0f;                ///< metres, of the projectile
    std::optional<DentForm> form;       ///< ProjectileSettings::form
};

/// The Bullet world: targets, a floor, projectiles. Deterministic: the same calls give the same impacts.
class PhysicsWorld {
public:
    PhysicsWorld();
    ~PhysicsWorld();
    PhysicsWorld(const PhysicsWorld&) = delete;
    PhysicsWorld& operator=(const PhysicsWorld&) = delete;

    // Targets
    /// Replaces the target of that id, if there is one. An error, and no such target, when it cannot be hit:
    /// a collider without surface, a place or size that is not finite or beyond 10,000 km, a dynamic target
    /// larger than 100 km.
    [[nodiscard]] Status addTarget(TargetId target, const RigidTransform& transform, const Collider& collider,
                                   const TargetPhysics& physics = {});
    void removeTarget(TargetId target);
    [[nodiscard]] bool hasTarget(TargetId target) const;
    /// Puts it elsewhere, at rest, with its dents; no such target: nothing.
    [[nodiscard]] Status moveTarget(TargetId target, const RigidTransform& transform);
    /// Its dents stay. A dynamic target meets the floor and other targets as its convex hull, dents and all,
    /// or unhurt primitive; projectiles meet its triangles as they are. It turns about its box's original
    /// centre.
    [[nodiscard]] Status setTargetPhysics(TargetId target, const TargetPhysics& physics);
    /// Vertices [first, first + vertices.size()) of its collider's surface are now there (local frame): from
    /// now on that is what is hit. Costs by the vertices that moved, not by the mesh. Out of range: ignored.
    void updateTarget(TargetId target, std::uint32_t first, std::span<const DynamicVertex> vertices);
    /// All vertices are back at the original shape.
    void resetTarget(TargetId target);
    /// Likewise updateTarget(), but only for what is asked: castRay(), predict() and trianglesNear() find the
    /// vertices there, and what flies meets them where they were. updateTarget() moves them for both.
    void updateForQuestions(TargetId target, std::uint32_t first, std::span<const DynamicVertex> vertices);
    /// What is asked is answered from what is hit again; gives back the memory of the other.
    void answerFromWhatIsHit(TargetId target);
    [[nodiscard]] std::vector<TargetPose> dynamicTargets() const;
    /// An endless horizontal floor at height y metres; projectiles rest on it, it takes no hits. Those that
    /// are shot from below pass it.
    void setFloor(float y);
    void removeFloor();

    // Shots
    /// Launches a projectile from `origin` (metres, world) along `direction` (unit). It never tunnels.
    /// Settings out of range are clamped. Nothing is launched, and id 0 comes back, when origin or direction
    /// is not finite or the direction is zero. Projectiles of one volley (> 0) pass through each other: they
    /// may leave from one point.
    ProjectileId shoot(const glm::vec3& origin, const glm::vec3& direction,
                       const ProjectileSettings& settings, int volley = 0);
    /// An instant shot without flight, along a straight line: what a projectile of these settings would do
    /// that struck just there. Nothing when no target is first on the line.
    [[nodiscard]] std::optional<Impact> hitscan(const glm::vec3& origin, const glm::vec3& direction,
                                                const ProjectileSettings& settings);
    /// What a shot would strike if nothing moved meanwhile, see updateForQuestions(); changes nothing. In
    /// flight it falls, in the world's own steps; one that meets the floor first strikes nothing.
    [[nodiscard]] std::optional<Impact> predict(const glm::vec3& origin, const glm::vec3& direction,
                                                const ProjectileSettings& settings, bool isInstant) const;
    /// Whether in the next step a projectile that has not struck this target as the last one it struck comes
    /// within `reach` metres of its box (infinite: whether there is such a projectile).
    [[nodiscard]] bool isApproached(TargetId target, float reach) const;
    void removeProjectiles();
    void removeProjectile(ProjectileId id);  ///< nothing where it is gone; not in the middle of a step
    /// What became of a flight, beside its impacts.
    struct FlightEvent {
        enum class Kind : std::uint8_t {
            Landed,  ///< it struck the floor, for the first time
            Over,    ///< it is gone
        };
        ProjectileId projectile;
        Kind kind = Kind::Over;
    };
    /// In the order they happened, since the last call. Those of removeProjectiles() are none.
    [[nodiscard]] std::vector<FlightEvent> takeFlightEvents();
    [[nodiscard]] std::vector<ProjectileState> projectiles() const;
    [[nodiscard]] std::size_t projectileCount() const;

    // Time
    /// How long steps are and how many are due; see takeStep().
    [[nodiscard]] StepClock& clock();
    [[nodiscard]] const StepClock& clock() const;
    /// Takes the steps due after `seconds` (see StepClock::stepsDue()). Returns the impacts in the order they
    /// happened.
    [[nodiscard]] std::vector<Impact> advance(double seconds);
    /// Takes a step, or goes on with the one under way, until time is up: some of it is always done, and a
    /// step taken in parts comes out the same. Returns its impacts, or nothing while it is under way.
    /// Whatever else changes the world finishes it first; its impacts are then had by the next call.
    [[nodiscard]] std::optional<std::vector<Impact>> takeStep(const IsTimeUp& isTimeUp);
    [[nodiscard]] std::vector<Impact> takeStep();
    [[nodiscard]] bool isMidStep() const;
    /// One step, paused or not.
    [[nodiscard]] std::vector<Impact> stepOnce();
    /// Something would move if time went on.
    [[nodiscard]] bool isMoving() const;

    /// First target a straight line meets, without shooting: for aiming and recentring.
    struct RayHit {
        TargetId target;  ///< 0: the floor
        glm::vec3 point{0.0f};
        glm::vec3 normal{0.0f};
    };
    /// Nothing when the ray meets neither target nor floor within `length` metres. `direction` is unit.
    [[nodiscard]] std::optional<RayHit> castRay(const glm::vec3& origin, const glm::vec3& direction,
                                                float length) const;
    /// The triangles of a target's surface as it is now that may come within `distance` metres of `point`
    /// (local frame), and some more; ascending. Empty: no such target, or no triangles.
    [[nodiscard]] std::vector<std::uint32_t> trianglesNear(TargetId target, const glm::vec3& point,
                                                           float distance) const;

    static constexpr double kTrailSeconds = 0.15;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

}  // namespace hitscope
