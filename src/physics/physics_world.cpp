// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/physics_world.h"

#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>
#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "physics/bullet_conversions.h"
#include "physics/collision_shape.h"
#include "physics/motion_sweep.h"
#include "physics/touches.h"

namespace hitscope {

using namespace physics;

namespace {

const glm::vec3 kFall(0.0f, -PhysicsWorld::kGravity, 0.0f);  // m/s^2
constexpr float kStepSeconds = static_cast<float>(PhysicsWorld::kStep);
constexpr float kRestitution = 0.6f;
constexpr float kFriction = 0.6f;
constexpr float kRollingFriction = 0.05f;  // metres: without it a sphere on a plane rolls for ever
constexpr float kLeastImpactSpeed = 1.0e-3f;
constexpr float kLeastBounceSpeed = 0.25f;  // along the normal: a projectile that rolls does not strike
// Of the radius: Bullet makes a contact only where bodies overlap, so a projectile that arrives is let in
// this far.
constexpr float kSinkIn = 0.002f;
constexpr float kMostSpeed = 1.0e4f;
constexpr float kMostLifetime = 3600.0f;

float clampedOr(float value, float low, float high, float fallback) {
    return std::isfinite(value) ? std::clamp(value, low, high) : fallback;
}

ProjectileSettings usable(ProjectileSettings settings) {
    const ProjectileSettings standard;
    settings.radius = clampedOr(settings.radius, 0.001f, 100.0f, standard.radius);
    settings.mass = clampedOr(settings.mass, 0.001f, 1.0e6f, standard.mass);
    settings.speed = clampedOr(settings.speed, 0.0f, kMostSpeed, standard.speed);
    settings.lifetime = clampedOr(settings.lifetime, 0.0f, kMostLifetime, standard.lifetime);
    return settings;
}

void setSurface(btRigidBody& body) {
    body.setRestitution(kRestitution);
    body.setFriction(kFriction);
    body.setRollingFriction(kRollingFriction);
}

std::unique_ptr<btRigidBody> makeStaticBody(btCollisionShape* shape, BodyKind kind, std::uint32_t id) {
    const btRigidBody::btRigidBodyConstructionInfo info(0.0f, nullptr, shape);
    auto body = std::make_unique<btRigidBody>(info);
    setSurface(*body);
    body->setUserIndex(static_cast<int>(kind));
    body->setUserIndex2(static_cast<int>(id));
    return body;
}

void moveTo(btRigidBody& body, const glm::vec3& position) {
    body.getWorldTransform().setOrigin(toBullet(position));
    body.setInterpolationWorldTransform(body.getWorldTransform());
}

struct TargetBody {
    RigidTransform transform;
    std::unique_ptr<CollisionShape> shape;
    std::unique_ptr<btRigidBody> body;
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
    std::int64_t endStep = 0;        ///< the step after which it disappears
    bool hasHit = false;             ///< it has made a hit
    std::vector<TargetId> touching;  ///< after the last step; sorted
    glm::vec3 velocity{0.0f};        ///< just before any impact of this step, m/s
    std::optional<Strike> strike;

    [[nodiscard]] bool touches(TargetId target) const {
        return std::binary_search(touching.begin(), touching.end(), target);
    }
};

}  // namespace

struct PhysicsWorld::Private {
    Private();
    ~Private();
    Private(const Private&) = delete;
    Private& operator=(const Private&) = delete;

    void step(std::vector<Impact>& impacts);
    void approach(Flight& flight);
    void collect(ProjectileId id, Flight& flight, const std::map<TouchKey, Touch>& contacts,
                 std::vector<Impact>& impacts);
    void stopAtSurface(Flight& flight, Touch& touch);
    void strike(ProjectileId id, Flight& flight, TargetId target, const Touch& touch,
                std::vector<Impact>& impacts);
    void removeFlight(std::map<ProjectileId, Flight>::iterator flight);
    void removeSpentFlights();
    void wakeAll();
    [[nodiscard]] std::optional<SurfacePoint> surfacePoint(TargetId target, const glm::vec3& from,
                                                           int triangle) const;

    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
    std::map<TargetId, TargetBody> targets;
    std::map<ProjectileId, Flight> flights;
    std::unique_ptr<btStaticPlaneShape> floorShape;
    std::unique_ptr<btRigidBody> floor;
    std::uint32_t nextProjectile = 1;
    std::int64_t steps = 0;
    double waiting = 0.0;  ///< seconds not simulated yet, < kStep
};

PhysicsWorld::Private::Private() {
    world.setGravity(toBullet(kFall));
}

PhysicsWorld::Private::~Private() {
    // Bullet's world outlives none of its bodies.
    for (auto& [id, flight] : flights) {
        world.removeRigidBody(flight.body.get());
    }
    for (auto& [id, target] : targets) {
        world.removeRigidBody(target.body.get());
    }
    if (floor) {
        world.removeRigidBody(floor.get());
    }
}

void PhysicsWorld::Private::removeFlight(std::map<ProjectileId, Flight>::iterator flight) {
    world.removeRigidBody(flight->second.body.get());
    flights.erase(flight);
}

void PhysicsWorld::Private::wakeAll() {
    for (auto& [id, flight] : flights) {
        flight.body->activate(true);
    }
}

std::optional<SurfacePoint> PhysicsWorld::Private::surfacePoint(TargetId target, const glm::vec3& from,
                                                                int triangle) const {
    const auto found = targets.find(target);
    if (found == targets.end()) {
        return std::nullopt;
    }
    const RigidTransform& transform = found->second.transform;
    const auto local = found->second.shape->nearest(transform.toLocal(from), triangle);
    if (!local) {
        return std::nullopt;
    }
    return SurfacePoint{transform.toWorld(local->point), transform.directionToWorld(local->normal)};
}

/// Looks ahead along the step's motion and puts the projectile where it first touches something, its velocity
/// untouched: Bullet then finds the contact with the full velocity of the flight and solves it in this step.
/// Left to itself it would brake the projectile short of the surface over several steps.
void PhysicsWorld::Private::approach(Flight& flight) {
    flight.strike.reset();
    btRigidBody& body = *flight.body;
    flight.velocity = fromBullet(body.getLinearVelocity());
    if (!body.isActive()) {
        return;
    }
    flight.velocity += kFall * kStepSeconds;
    const glm::vec3 motion = flight.velocity * kStepSeconds;
    const glm::vec3 start = fromBullet(body.getWorldTransform().getOrigin());
    if (glm::length(motion) < 1.0e-6f) {
        return;
    }
    const auto contact = sweep(world, body, *flight.shape, start, motion);
    if (!contact) {
        return;
    }
    const int kind = contact->body->getUserIndex();
    const TargetId target{static_cast<std::uint32_t>(contact->body->getUserIndex2())};
    const bool strikes = kind == static_cast<int>(BodyKind::Target) && !flight.touches(target);
    const bool lands = kind == static_cast<int>(BodyKind::Floor) && -motion.y > 0.5f * flight.settings.radius;
    if (!strikes && !lands) {
        return;
    }
    glm::vec3 centre = start + motion * contact->fraction;
    if (strikes) {
        if (const auto surface = surfacePoint(target, centre, contact->triangle)) {
            flight.strike = Strike{target, *surface};
            centre = surface->point + surface->normal * ((1.0f - kSinkIn) * flight.settings.radius);
        }
    }
    moveTo(body, centre);
}

/// Bullet found no contact where its own cast did: bounce the projectile as Bullet would have.
void PhysicsWorld::Private::stopAtSurface(Flight& flight, Touch& touch) {
    const glm::vec3 normal = touch.deepest.normal;
    const float inwards = -glm::dot(flight.velocity, normal);
    if (inwards <= 0.0f) {
        return;
    }
    touch.impulse = flight.settings.mass * inwards * (1.0f + kRestitution * kRestitution);
    btRigidBody& body = *flight.body;
    moveTo(body, touch.deepest.point + normal * flight.settings.radius);
    body.setLinearVelocity(toBullet(flight.velocity + normal * (touch.impulse / flight.settings.mass)));
}

void PhysicsWorld::Private::strike(ProjectileId id, Flight& flight, TargetId target, const Touch& touch,
                                   std::vector<Impact>& impacts) {
    const float speed = glm::length(flight.velocity);
    const float inwards = -glm::dot(flight.velocity, touch.deepest.normal);
    const bool counts = flight.hasHit ? flight.settings.bouncesCount && inwards >= kLeastBounceSpeed
                                      : speed >= kLeastImpactSpeed;
    if (!counts) {
        return;
    }
    flight.hasHit = true;
    Impact impact;
    impact.target = target;
    impact.projectile = id;
    impact.point = touch.deepest.point;
    impact.direction = flight.velocity / speed;
    impact.normal = touch.deepest.normal;
    impact.speed = speed;
    impact.impulse = touch.impulse;
    impact.time = static_cast<double>(steps) * kStep;
    impacts.push_back(impact);
}

void PhysicsWorld::Private::collect(ProjectileId id, Flight& flight,
                                    const std::map<TouchKey, Touch>& contacts, std::vector<Impact>& impacts) {
    std::map<TargetId, Touch> touched;
    for (auto it = contacts.lower_bound({id, TargetId{0}}); it != contacts.end() && it->first.first == id;
         ++it) {
        touched.emplace(it->first.second, it->second);
    }
    if (flight.strike) {
        Touch& touch = touched[flight.strike->target];
        touch.deepest = flight.strike->surface;
        if (touch.impulse <= 0.0f) {
            stopAtSurface(flight, touch);
        }
    }
    std::vector<TargetId> touching;
    for (const auto& [target, touch] : touched) {
        touching.push_back(target);
        if (!flight.touches(target)) {
            strike(id, flight, target, touch, impacts);
        }
    }
    flight.touching = std::move(touching);
}

void PhysicsWorld::Private::removeSpentFlights() {
    for (auto it = flights.begin(); it != flights.end();) {
        const auto current = it++;
        const glm::vec3 position = fromBullet(current->second.body->getWorldTransform().getOrigin());
        if (steps >= current->second.endStep || !isUsable(position)) {
            removeFlight(current);
        }
    }
}

void PhysicsWorld::Private::step(std::vector<Impact>& impacts) {
    ++steps;
    if (flights.empty()) {
        return;
    }
    for (auto& [id, flight] : flights) {
        approach(flight);
    }
    world.stepSimulation(kStepSeconds, 0);
    const auto contacts = touches(dispatcher);
    for (auto& [id, flight] : flights) {
        collect(id, flight, contacts, impacts);
    }
    removeSpentFlights();
}

PhysicsWorld::PhysicsWorld() : d(std::make_unique<Private>()) {}
PhysicsWorld::~PhysicsWorld() = default;

void PhysicsWorld::addTarget(TargetId target, const RigidTransform& transform, const Collider& collider) {
    removeTarget(target);
    const float turn = glm::length(transform.rotation);
    if (!isUsable(transform.position) || !(turn > 0.0f) || !std::isfinite(turn)) {
        return;
    }
    TargetBody entry;
    entry.transform = {transform.position, transform.rotation / turn};
    entry.shape = CollisionShape::make(collider);
    if (!entry.shape) {
        return;
    }
    entry.body = makeStaticBody(entry.shape->bullet(), BodyKind::Target, target.value);
    entry.body->setWorldTransform(
        btTransform(toBullet(entry.transform.rotation), toBullet(entry.transform.position)));
    d->world.addRigidBody(entry.body.get());
    d->targets.emplace(target, std::move(entry));
    d->wakeAll();
}

void PhysicsWorld::removeTarget(TargetId target) {
    const auto found = d->targets.find(target);
    if (found == d->targets.end()) {
        return;
    }
    d->world.removeRigidBody(found->second.body.get());
    d->targets.erase(found);
    for (auto& [id, flight] : d->flights) {
        std::erase(flight.touching, target);
    }
    d->wakeAll();
}

void PhysicsWorld::setFloor(float y) {
    removeFloor();
    if (!(std::abs(y) <= kFarthest)) {
        return;
    }
    d->floorShape = std::make_unique<btStaticPlaneShape>(btVector3(0, 1, 0), y);
    d->floor = makeStaticBody(d->floorShape.get(), BodyKind::Floor, 0);
    d->world.addRigidBody(d->floor.get());
    d->wakeAll();
}

void PhysicsWorld::removeFloor() {
    if (d->floor) {
        d->world.removeRigidBody(d->floor.get());
        d->floor.reset();
        d->floorShape.reset();
        d->wakeAll();
    }
}

ProjectileId PhysicsWorld::shoot(const glm::vec3& origin, const glm::vec3& direction,
                                 const ProjectileSettings& settings) {
    const float length = glm::length(direction);
    if (!isUsable(origin) || !(length > 0.0f) || !std::isfinite(length)) {
        return {};
    }
    Flight flight;
    flight.settings = usable(settings);
    const ProjectileSettings& shot = flight.settings;
    flight.shape = std::make_unique<btSphereShape>(shot.radius);
    btVector3 inertia(0, 0, 0);
    flight.shape->calculateLocalInertia(shot.mass, inertia);
    const btRigidBody::btRigidBodyConstructionInfo info(shot.mass, nullptr, flight.shape.get(), inertia);
    flight.body = std::make_unique<btRigidBody>(info);
    btRigidBody& body = *flight.body;
    setSurface(body);
    const ProjectileId id{d->nextProjectile++};
    body.setUserIndex(static_cast<int>(BodyKind::Projectile));
    body.setUserIndex2(static_cast<int>(id.value));
    const btTransform where(btQuaternion::getIdentity(), toBullet(origin));
    body.setWorldTransform(where);
    body.setInterpolationWorldTransform(where);
    body.setLinearVelocity(toBullet(direction * (shot.speed / length)));
    // Motion of more than half a radius a step is swept by Bullet too: it keeps what a bounce sends elsewhere
    // within the same step, and projectiles that meet, from passing through.
    body.setCcdMotionThreshold(0.5f * shot.radius);
    body.setCcdSweptSphereRadius(0.9f * shot.radius);
    d->world.addRigidBody(&body);
    flight.endStep = d->steps + std::max<std::int64_t>(1, std::llround(shot.lifetime / kStep));
    d->flights.emplace(id, std::move(flight));
    return id;
}

void PhysicsWorld::removeProjectiles() {
    while (!d->flights.empty()) {
        d->removeFlight(d->flights.begin());
    }
}

std::vector<Impact> PhysicsWorld::advance(double seconds) {
    std::vector<Impact> impacts;
    if (!(seconds > 0.0) || !std::isfinite(seconds)) {
        return impacts;
    }
    d->waiting += seconds;
    // A frame of exactly n steps must not lose one to rounding.
    const double due = std::floor(d->waiting / kStep + 1.0e-6);
    const int count = static_cast<int>(std::min(due, static_cast<double>(kMaxSteps)));
    d->waiting = due > kMaxSteps ? 0.0 : std::max(0.0, d->waiting - count * kStep);
    for (int i = 0; i < count; ++i) {
        d->step(impacts);
    }
    return impacts;
}

std::vector<ProjectileState> PhysicsWorld::projectiles() const {
    std::vector<ProjectileState> states;
    states.reserve(d->flights.size());
    for (const auto& [id, flight] : d->flights) {
        states.push_back(
            {id, fromBullet(flight.body->getWorldTransform().getOrigin()), flight.settings.radius});
    }
    return states;
}

std::size_t PhysicsWorld::projectileCount() const {
    return d->flights.size();
}

double PhysicsWorld::time() const {
    return static_cast<double>(d->steps) * kStep;
}

std::optional<PhysicsWorld::RayHit> PhysicsWorld::castRay(const glm::vec3& origin, const glm::vec3& direction,
                                                          float length) const {
    if (!isUsable(origin) || !isUsable(direction) || !(length > 0.0f)) {
        return std::nullopt;
    }
    const glm::vec3 end = origin + direction * std::min(length, kFarthest);
    const auto contact = castLine(d->world, origin, end);
    if (!contact) {
        return std::nullopt;
    }
    const TargetId target{static_cast<std::uint32_t>(contact->body->getUserIndex2())};
    RayHit hit{target, glm::mix(origin, end, contact->fraction), contact->normal};
    // The fraction of a long line is coarse: back onto the surface.
    if (const auto surface = d->surfacePoint(target, hit.point, contact->triangle)) {
        hit.point = surface->point;
    }
    return hit;
}

}  // namespace hitscope
