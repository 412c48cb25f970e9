// SPDX-License-Identifier: GPL-3.0-or-later
// Projectiles, instant shots, rays.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "physics/bullet_conversions.h"
#include "physics/physics_world.h"
#include "physics/world_private.h"

namespace hitscope {

using namespace physics;

namespace {

constexpr float kWholeWorld = 2.0f * kFarthest;  // metres: longer than any line between two usable points

constexpr float kNearFactor = 1.1f;     // of the radius
constexpr float kSleepingSpeed = 0.8f;  // m/s: Bullet's own, for the paper's projectile

bool isDirection(const glm::vec3& v) {
    const float length = glm::length(v);
    return length > 0.0f && std::isfinite(length);
}

/// A sphere of these settings, not in the world yet.
Flight makeFlight(const ProjectileSettings& settings, const glm::vec3& origin, const glm::vec3& direction) {
    Flight flight;
    flight.settings = settings;
    flight.shape = std::make_unique<btSphereShape>(settings.radius);
    btVector3 inertia(0, 0, 0);
    flight.shape->calculateLocalInertia(settings.mass, inertia);
    const btRigidBody::btRigidBodyConstructionInfo info(settings.mass, nullptr, flight.shape.get(), inertia);
    flight.body = std::make_unique<btRigidBody>(info);
    btRigidBody& body = *flight.body;
    body.setRestitution(kRestitution);
    body.setFriction(kFriction);
    body.setRollingFriction(kRollingFriction);
    body.setSleepingThresholds(kSleepingSpeed * sizeOf(settings), body.getAngularSleepingThreshold());
    const btTransform where(btQuaternion::getIdentity(), toBullet(origin));
    body.setWorldTransform(where);
    body.setInterpolationWorldTransform(where);
    body.setLinearVelocity(toBullet(glm::normalize(direction) * settings.speed));
    flight.previous = origin;
    flight.position = origin;
    return flight;
}

}  // namespace

bool Flight::touches(TargetId target) const {
    return std::binary_search(touching.begin(), touching.end(), target);
}

ProjectileId PhysicsWorld::shoot(const glm::vec3& origin, const glm::vec3& direction,
                                 const ProjectileSettings& settings, int volley) {
    if (!isUsable(origin) || !isDirection(direction)) {
        return {};
    }
    d->finishStep();
    const ProjectileSettings shot = clamped(settings);
    while (d->flights.size() >= static_cast<std::size_t>(shot.mostAlive)) {
        d->removeFlight(d->flights.begin());
    }
    Flight flight = makeFlight(shot, origin, direction);
    const ProjectileId id{d->nextProjectile++};
    flight.body->setUserIndex(static_cast<int>(BodyKind::Projectile));
    flight.body->setUserIndex2(static_cast<int>(id.value));
    flight.body->setUserIndex3(shot.passesOthers ? VolleyFilter::kPassesAll : volley);
    // Half a step less, so that rounding never adds one; it lives for a step at least.
    flight.end = d->clock.time() +
                 std::max(0.5 * d->clock.step(), static_cast<double>(shot.lifetime) - 0.5 * d->clock.step());
    flight.isUnderFloor = d->floor && origin.y < d->floorShape->getPlaneConstant();
    d->world.addRigidBody(
        flight.body.get(), btBroadphaseProxy::DefaultFilter,
        flight.isUnderFloor ? btBroadphaseProxy::AllFilter & ~kFloorGroup : btBroadphaseProxy::AllFilter);
    flight.body->setGravity(toBullet(fallOf(shot)));  // the world has just set its own
    Flight& kept = d->flights.emplace(id, std::move(flight)).first->second;
    kept.body->setUserPointer(&kept.ahead);
    return id;
}

void Flight::keepTrail() {
    if (trailCount == kTrailPoints) {
        std::copy(trail.begin() + 1, trail.end(), trail.begin());
        --trailCount;
    }
    trail[trailCount++] = previous;
}

void PhysicsWorld::Private::removeFlight(std::map<ProjectileId, Flight>::iterator flight) {
    world.removeRigidBody(flight->second.body.get());
    events.push_back({flight->first, FlightEvent::Kind::Over});
    flights.erase(flight);
}

void PhysicsWorld::removeProjectiles() {
    d->finishStep();
    while (!d->flights.empty()) {
        d->removeFlight(d->flights.begin());
    }
    d->events.clear();
}

void PhysicsWorld::removeProjectile(ProjectileId id) {
    if (const auto flight = d->flights.find(id); flight != d->flights.end()) {
        d->removeFlight(flight);
    }
}

std::vector<PhysicsWorld::FlightEvent> PhysicsWorld::takeFlightEvents() {
    return std::exchange(d->events, {});
}

std::vector<ProjectileState> PhysicsWorld::projectiles() const {
    std::vector<ProjectileState> states;
    states.reserve(d->flights.size());
    for (const auto& [id, flight] : d->flights) {
        states.push_back({id, flight.position, glm::mix(flight.previous, flight.position, d->clock.between()),
                          fromBullet(flight.body->getLinearVelocity()), flight.settings.radius,
                          flight.settings.colour, std::span(flight.trail).first(flight.trailCount)});
    }
    return states;
}

std::size_t PhysicsWorld::projectileCount() const {
    return d->flights.size();
}

bool PhysicsWorld::isApproached(TargetId target, float reach) const {
    const auto found = d->targets.find(target);
    if (found == d->targets.end()) {
        return false;
    }
    btVector3 least;
    btVector3 most;
    found->second.body->getAabb(least, most);
    const auto step = static_cast<btScalar>(d->clock.step());
    const auto comesNear = [&](const Flight& flight) {
        const btVector3 from = flight.body->getWorldTransform().getOrigin();
        const btVector3 to =
            from + (flight.body->getLinearVelocity() + flight.body->getGravity() * step) * step;
        const btScalar around = flight.settings.radius * kNearFactor + reach;
        const btVector3 grown(around, around, around);
        btVector3 low = from;
        low.setMin(to);
        btVector3 high = from;
        high.setMax(to);
        return TestAabbAgainstAabb2(low - grown, high + grown, least, most);
    };
    return std::any_of(d->flights.begin(), d->flights.end(), [&](const auto& entry) {
        return entry.second.lastStruck != target && comesNear(entry.second);
    });
}

std::optional<SurfacePoint> PhysicsWorld::Private::surfacePoint(TargetId target, const glm::vec3& from,
                                                                int triangle, Use use) const {
    const auto found = targets.find(target);
    if (found == targets.end()) {
        return std::nullopt;
    }
    const RigidTransform& transform = found->second.transform;
    const auto local = found->second.shapeFor(use).nearest(transform.toLocal(from), triangle);
    if (!local) {
        return std::nullopt;
    }
    return SurfacePoint{transform.toWorld(local->point), transform.directionToWorld(local->normal),
                        local->triangle};
}

std::optional<PhysicsWorld::RayHit> PhysicsWorld::castRay(const glm::vec3& origin, const glm::vec3& direction,
                                                          float length) const {
    if (!isUsable(origin) || !isUsable(direction) || !(length > 0.0f)) {
        return std::nullopt;
    }
    const auto struck = d->castLine(origin, direction * std::min(length, kWholeWorld), Use::Question);
    return struck ? std::optional(RayHit{struck->target, struck->surface.point, struck->surface.normal})
                  : std::nullopt;
}

std::optional<Strike> PhysicsWorld::Private::castLine(const glm::vec3& origin, const glm::vec3& motion,
                                                      Use use) {
    const auto contact = surfacesNow(use).sweep(origin, motion, 0.0f);
    if (!contact) {
        return std::nullopt;
    }
    const glm::vec3 point(glm::dvec3(origin) + glm::dvec3(motion) * contact->fraction);
    if (!contact->target) {
        return Strike{{}, {point, glm::vec3(0, 1, 0), -1}};
    }
    const TargetBody& target = targets.at(contact->target);
    const glm::vec3 local = target.transform.toLocal(point);
    const glm::vec3 outwards =
        target.transform.directionToWorld(target.shapeFor(use).normalAt(local, contact->triangle));
    const glm::vec3 normal = glm::dot(outwards, motion) > 0.0f ? -outwards : outwards;
    return Strike{contact->target, {point, normal, contact->triangle}};
}

std::optional<Impact> PhysicsWorld::hitscan(const glm::vec3& origin, const glm::vec3& direction,
                                            const ProjectileSettings& settings) {
    if (!isUsable(origin) || !isDirection(direction)) {
        return std::nullopt;
    }
    d->finishStep();
    const auto struck = d->castLine(origin, glm::normalize(direction) * kWholeWorld, Use::Motion);
    if (!struck || !struck->target) {
        return std::nullopt;
    }
    Flight flight = makeFlight(clamped(settings), origin, direction);
    flight.velocity = glm::normalize(direction) * flight.settings.speed;
    Touch touch{glm::vec3(0.0f), struck->surface, 0.0f};
    TargetBody& target = d->targets.at(struck->target);
    bounce(flight, target, touch);
    return impactOf(struck->target, target.transform, flight.velocity, touch, d->clock.time(),
                    flight.settings);
}

std::optional<Impact> PhysicsWorld::predict(const glm::vec3& origin, const glm::vec3& direction,
                                            const ProjectileSettings& settings, bool isInstant) const {
    if (!isUsable(origin) || !isDirection(direction)) {
        return std::nullopt;
    }
    const ProjectileSettings shot = clamped(settings);
    glm::vec3 velocity = glm::normalize(direction) * shot.speed;
    double time = d->clock.time();
    const std::optional<Strike> struck =
        isInstant ? d->castLine(origin, glm::normalize(direction) * kWholeWorld, Use::Question)
                  : d->fly(origin, shot, velocity, time);
    if (!struck || !struck->target) {
        return std::nullopt;
    }
    const TargetBody& target = d->targets.at(struck->target);
    const glm::vec3& normal = struck->surface.normal;
    const Touch touch{normal * bounceImpulse(velocity, shot.mass, target.physics, normal), struck->surface,
                      0.0f};
    return impactOf(struck->target, target.transform, velocity, touch, time, shot);
}

/// As step() would move it.
std::optional<Strike> PhysicsWorld::Private::fly(glm::vec3 position, const ProjectileSettings& shot,
                                                 glm::vec3& velocity, double& now) {
    const SweepScene scene = surfacesNow(Use::Question);
    const auto seconds = static_cast<float>(clock.step());
    const auto most = static_cast<int>(std::ceil(static_cast<double>(shot.lifetime) / clock.step()));
    for (int i = 0; i < most && isUsable(position); ++i) {
        velocity += fallOf(shot) * seconds;
        now += clock.step();
        const glm::vec3 motion = velocity * seconds;
        const auto contact = scene.sweep(position, motion, shot.radius);
        if (contact && !contact->target) {
            return std::nullopt;
        }
        if (contact) {
            const glm::vec3 centre = position + motion * static_cast<float>(contact->fraction);
            const auto surface = surfacePoint(contact->target, centre, contact->triangle, Use::Question);
            return surface ? std::optional(Strike{contact->target, *surface}) : std::nullopt;
        }
        position += motion;
    }
    return std::nullopt;
}

std::vector<std::uint32_t> PhysicsWorld::trianglesNear(TargetId target, const glm::vec3& point,
                                                       float distance) const {
    const auto found = d->targets.find(target);
    std::vector<std::uint32_t> near = found == d->targets.end()
                                          ? std::vector<std::uint32_t>()
                                          : found->second.shapeFor(Use::Question).near(point, distance);
    std::sort(near.begin(), near.end());
    return near;
}

}  // namespace hitscope
