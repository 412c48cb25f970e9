// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <btBulletDynamicsCommon.h>

#include <array>
#include <map>
#include <span>
#include <vector>

#include "physics/ball_contacts.h"
#include "physics/mesh_contacts.h"
#include "physics/motion_sweep.h"
#include "physics/physics_world.h"
#include "physics/stepped_world.h"
#include "physics/touches.h"
#include "physics/volley_filter.h"

namespace hitscope {

namespace physics {

/// What a second of falling adds to a projectile's velocity, m/s.
inline glm::vec3 fallOf(const ProjectileSettings& shot) {
    return {0.0f, -shot.gravity, 0.0f};
}
/// How many times the paper's projectile this one is: what Bullet and we take for small goes by it.
inline float sizeOf(const ProjectileSettings& shot) {
    return shot.radius / ProjectileSettings().radius;
}
/// Bullet's group of the floor alone: what comes from below does not meet it.
inline constexpr int kFloorGroup = 1 << 6;

inline constexpr float kRestitution = 0.6f;  // of projectiles and the floor; Bullet multiplies the two
inline constexpr float kFriction = 0.6f;
inline constexpr float kRollingFriction = 0.05f;  // metres: without it a sphere on a plane rolls for ever

/// What a surface is wanted for: questions see dents that what moves meets some steps later.
enum class Use : std::uint8_t { Motion, Question };

struct TargetBody {
    RigidTransform transform;  ///< after the last step
    RigidTransform previous;   ///< before it
    TargetPhysics physics;
    std::unique_ptr<CollisionShape> shape;
    std::unique_ptr<CollisionShape>
        asked;  ///< the same with newer dents, for questions; null: there are none
    std::unique_ptr<btRigidBody> body;
    bool hullIsOld = false;  ///< its surface moved since its hull was made

    void place();  ///< the body to `transform`, at rest
    [[nodiscard]] const CollisionShape& shapeFor(Use use) const {
        return use == Use::Question && asked ? *asked : *shape;
    }
};

/// What a projectile is about to strike in this step.
struct Strike {
    TargetId target;
    SurfacePoint surface;  ///< world
};

struct Flight {
    ProjectileSettings settings;
    std::unique_ptr<btSphereShape> shape;
    std::unique_ptr<btRigidBody> body;
    double end = 0.0;                ///< simulated time when it disappears
    bool hasHit = false;             ///< it has made a hit
    bool hasLanded = false;          ///< it has struck the floor
    bool isUnderFloor = false;       ///< it has not come up yet
    TargetId lastStruck;             ///< 0: none
    std::vector<TargetId> touching;  ///< after the last step; sorted
    glm::vec3 velocity{0.0f};        ///< just before any impact of this step, m/s
    glm::vec3 previous{0.0f};        ///< position before the last step
    glm::vec3 position{0.0f};        ///< after it; the body's own moves in parts of a step
    std::optional<Strike> strike;
    bool meetsNothing = false;         ///< in this step, as the sweep has it
    std::vector<ContactsAhead> ahead;  ///< of this step; the body's user pointer
    static constexpr std::size_t kTrailPoints = 12;
    std::array<glm::vec3, kTrailPoints> trail;  ///< oldest first
    std::size_t trailCount = 0;

    void keepTrail();  ///< adds `previous`
    [[nodiscard]] bool touches(TargetId target) const;
    [[nodiscard]] bool strikes(TargetId target) const { return strike && strike->target == target; }
    /// It strikes what it touches there, and does not pass by or fly away.
    [[nodiscard]] bool isPushed(TargetId target, const Touch& touch) const;
    [[nodiscard]] bool bounces(TargetId target, const Touch& touch) const;   ///< a hit after its first one
    [[nodiscard]] bool makesHit(TargetId target, const Touch& touch) const;  ///< first one or not
};

/// Bounces a flight off a target where it touches, as Bullet would have, and pushes a dynamic target; writes
/// the push into `touch`. Moving away: nothing.
void bounce(Flight& flight, TargetBody& target, Touch& touch);

/// Newton seconds that a projectile of `mass` takes from a target it meets with `velocity` (m/s) where the
/// normal (unit) is that; 0 when it moves away.
[[nodiscard]] float bounceImpulse(const glm::vec3& velocity, float mass, const TargetPhysics& target,
                                  const glm::vec3& normal);

/// `where`: of the target when the touch was found. `shot`: of the projectile.
[[nodiscard]] Impact impactOf(TargetId target, const RigidTransform& where, const glm::vec3& velocity,
                              const Touch& touch, double time, const ProjectileSettings& shot);

}  // namespace physics

struct PhysicsWorld::Private {
    Private();
    ~Private();
    Private(const Private&) = delete;
    Private& operator=(const Private&) = delete;

    // physics_step.cpp
    /// Begins a step or goes on with it; returns whether it is over.
    bool step(const IsTimeUp& isTimeUp);
    bool beginStep();
    bool approachAll(const IsTimeUp& isTimeUp);
    void endStep();
    /// Before the world changes.
    void finishStep();
    void followHulls();
    [[nodiscard]] physics::SweepScene surfacesNow(physics::Use use) const;
    void approach(ProjectileId id, physics::Flight& flight);
    void touchAhead(physics::Flight& flight);
    void collect(ProjectileId id, physics::Flight& flight, std::span<const physics::TouchEntry> contacts);
    void takeBack(physics::Flight& flight, TargetId target, physics::Touch& touch) const;
    void settleStrike(physics::Flight& flight, std::map<TargetId, physics::Touch>& touches);
    void strike(ProjectileId id, physics::Flight& flight, TargetId target, const physics::Touch& touch);
    void comeUp(physics::Flight& flight) const;
    void followDynamicTargets();
    void removeSpentFlights();
    void keepTrails();

    void addBody(physics::TargetBody& target);
    void wakeWhatTouches(TargetId id, const physics::TargetBody& target);
    void reshape(TargetId id, physics::TargetBody& target, const physics::CollisionShape::Change& change);
    /// First target, or the floor (target 0), on a line.
    [[nodiscard]] std::optional<physics::Strike> castLine(const glm::vec3& origin, const glm::vec3& motion,
                                                          physics::Use use);
    /// Where a projectile from `position` first strikes something; `velocity` (m/s) and `now` (simulated
    /// time) become those of that moment.
    [[nodiscard]] std::optional<physics::Strike> fly(glm::vec3 position, const ProjectileSettings& shot,
                                                     glm::vec3& velocity, double& now);
    void removeFlight(std::map<ProjectileId, physics::Flight>::iterator flight);
    void letBounceSlowly();
    void wakeAll();
    [[nodiscard]] std::optional<physics::SurfacePoint> surfacePoint(TargetId target, const glm::vec3& from,
                                                                    int triangle, physics::Use use) const;

    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    physics::MeshContacts meshContacts{dispatcher};
    physics::BallContacts ballContacts{dispatcher};
    btDbvtBroadphase broadphase;
    physics::VolleyFilter volleyFilter;
    btSequentialImpulseConstraintSolver solver;
    physics::SweepScene surfaces;  ///< as of the beginning of the last step
    physics::SteppedWorld world{dispatcher, broadphase, solver, configuration, surfaces};
    std::vector<physics::TouchEntry> contacts;  ///< of the last step
    std::map<TargetId, physics::TargetBody> targets;
    std::map<ProjectileId, physics::Flight> flights;
    std::unique_ptr<btStaticPlaneShape> floorShape;
    std::unique_ptr<btRigidBody> floor;
    std::vector<FlightEvent> events;  ///< since they were last taken
    /// What of a step is under way; what comes first in it is done in parts by projectile.
    enum class StepPart : std::uint8_t { None, Approach, Solve, Move };
    StepPart part = StepPart::None;
    ProjectileId nextToApproach;
    std::vector<Impact> impacts;  ///< of the step under way, or of one that is over and not taken yet
    bool isStepToTake = false;    ///< the latter
    std::uint32_t nextProjectile = 1;
    StepClock clock{[this] { finishStep(); }};
};

}  // namespace hitscope
