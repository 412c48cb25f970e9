// SPDX-License-Identifier: GPL-3.0-or-later
// One step: projectiles are brought to what they strike, Bullet solves, impacts are collected.
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

// For the paper's projectile.
constexpr float kLeastImpactSpeed = 1.0e-3f;
constexpr float kLeastBounceSpeed = 0.25f;  // along the normal: a projectile that rolls does not strike
constexpr float kLeastRestitution = 0.2f;   // m/s: Bullet's own; what is slower does not bounce
constexpr float kNoMotion = 1.0e-5f;        // of the radius, in a step
// Of the radius: Bullet makes a contact only where bodies overlap, so a projectile that arrives is let in
// this far.
constexpr float kSinkIn = 0.002f;
// Of the radius: a projectile that moves less in a step and touches a target lies there or rolls. Bullet's
// contacts are enough for that, and a sweep along a fine surface is what costs most.
constexpr float kRollingMotion = 0.25f;

void moveTo(btRigidBody& body, const glm::vec3& position) {
    body.getWorldTransform().setOrigin(toBullet(position));
    body.setInterpolationWorldTransform(body.getWorldTransform());
}

}  // namespace

float physics::bounceImpulse(const glm::vec3& velocity, float mass, const TargetPhysics& target,
                             const glm::vec3& normal) {
    const float inwards = std::max(0.0f, -glm::dot(velocity, normal));
    // Two bodies: the lighter one takes most of the change of speed.
    const float shared = target.isDynamic ? mass * target.mass / (mass + target.mass) : mass;
    return shared * inwards * (1.0f + kRestitution * target.restitution);
}

void physics::bounce(Flight& flight, TargetBody& target, Touch& touch) {
    const glm::vec3 normal = touch.deepest.normal;
    if (-glm::dot(flight.velocity, normal) <= 0.0f) {
        return;
    }
    const float mass = flight.settings.mass;
    const float impulse = bounceImpulse(flight.velocity, mass, target.physics, normal);
    touch.push = normal * impulse;
    btRigidBody& body = *flight.body;
    moveTo(body, touch.deepest.point + normal * flight.settings.radius);
    body.setLinearVelocity(toBullet(flight.velocity + normal * (impulse / mass)));
    if (target.physics.isDynamic) {
        target.body->activate(true);
        target.body->applyImpulse(toBullet(-touch.push), toBullet(touch.deepest.point) -
                                                             target.body->getWorldTransform().getOrigin());
    }
}

Impact physics::impactOf(TargetId target, const RigidTransform& where, const glm::vec3& velocity,
                         const Touch& touch, double time, const ProjectileSettings& shot) {
    Impact impact;
    impact.target = target;
    impact.point = touch.deepest.point;
    impact.speed = glm::length(velocity);
    impact.direction = velocity / impact.speed;
    impact.normal = touch.deepest.normal;
    impact.where = where;
    impact.triangle =
        touch.deepest.triangle < 0 ? kNoIndex : static_cast<std::uint32_t>(touch.deepest.triangle);
    // Where several walls push, friction with them takes some of it, and only the sum is what the projectile
    // feels.
    impact.impulse = std::max(0.0f, glm::dot(touch.push, touch.deepest.normal));
    impact.time = time;
    impact.radius = shot.radius;
    impact.form = shot.form;
    return impact;
}

SweepScene PhysicsWorld::Private::surfacesNow(Use use) const {
    SweepScene scene;
    for (const auto& [id, target] : targets) {
        scene.addTarget(id, target.body->getWorldTransform(), target.shapeFor(use));
    }
    if (floor) {
        scene.setFloor(floorShape->getPlaneConstant());
    }
    return scene;
}

/// Looks ahead along the step's motion and puts the projectile where it first touches something, its velocity
/// untouched: Bullet then finds the contact with the full velocity of the flight and solves it in this step.
/// Left to itself it would brake the projectile short of the surface over several steps.
void PhysicsWorld::Private::approach(ProjectileId id, Flight& flight) {
    flight.strike.reset();
    flight.meetsNothing = false;
    btRigidBody& body = *flight.body;
    flight.velocity = fromBullet(body.getLinearVelocity());
    if (!body.isActive()) {
        return;
    }
    flight.velocity += fallOf(flight.settings) * static_cast<float>(clock.step());
    const glm::vec3 motion = flight.velocity * static_cast<float>(clock.step());
    const float radius = flight.settings.radius;
    if (glm::length(motion) < kNoMotion * radius) {
        return;
    }
    if (!flight.touching.empty() && glm::length(motion) < kRollingMotion * radius) {
        return;
    }
    const auto contact = surfaces.sweep(flight.previous, motion, radius);
    flight.meetsNothing = !contact;
    if (!contact) {
        return;
    }
    const TargetId target = contact->target;
    if (!target && !std::exchange(flight.hasLanded, true)) {
        events.push_back({id, FlightEvent::Kind::Landed});
    }
    const bool strikes = target && !flight.touches(target);
    const bool lands = !target && -motion.y > 0.5f * radius;
    if (!strikes && !lands) {
        return;
    }
    glm::vec3 centre = flight.previous + motion * static_cast<float>(contact->fraction);
    if (strikes) {
        if (const auto surface = surfacePoint(target, centre, contact->triangle, Use::Motion)) {
            flight.strike = Strike{target, *surface};
            centre = surface->point + surface->normal * ((1.0f - kSinkIn) * radius);
        }
    }
    moveTo(body, centre);
}

/// What Bullet is going to ask for, so that it asks for nothing that takes long.
void PhysicsWorld::Private::touchAhead(Flight& flight) {
    flight.ahead.clear();
    if (!flight.body->isActive()) {
        return;
    }
    for (const auto& [id, target] : targets) {
        workOutContacts(*flight.body, *target.body, flight.ahead);
    }
}

bool Flight::isPushed(TargetId target, const Touch& touch) const {
    return strikes(target) ||
           (touch.push != glm::vec3(0.0f) && glm::dot(velocity, touch.deepest.normal) < 0.0f);
}

bool Flight::bounces(TargetId target, const Touch& touch) const {
    const float inwards = -glm::dot(velocity, touch.deepest.normal);
    return settings.bouncesCount && isPushed(target, touch) &&
           inwards >= kLeastBounceSpeed * std::min(1.0f, sizeOf(settings));
}

bool Flight::makesHit(TargetId target, const Touch& touch) const {
    const float least = kLeastImpactSpeed * std::min(1.0f, sizeOf(settings));
    return hasHit ? bounces(target, touch) : isPushed(target, touch) && glm::length(velocity) >= least;
}

void PhysicsWorld::Private::strike(ProjectileId id, Flight& flight, TargetId target, const Touch& touch) {
    flight.lastStruck = target;
    if (flight.makesHit(target, touch)) {
        flight.hasHit = true;
        // Where the target was when Bullet found the contact: it has moved on since.
        impacts.push_back(impactOf(target, targets.at(target).previous, flight.velocity, touch, clock.time(),
                                   flight.settings));
        impacts.back().projectile = id;
    }
}

/// The touch of what the sweep met first. Beside a seam Bullet lets a neighbour bear some of the blow, which
/// the strike is given here unless that is to be a hit of its own: all of the push is counted once.
void PhysicsWorld::Private::settleStrike(Flight& flight, std::map<TargetId, Touch>& touches) {
    const TargetId target = flight.strike->target;
    Touch& touch = touches[target];
    touch.deepest = flight.strike->surface;
    const bool missed = touch.push == glm::vec3(0.0f);
    for (auto& [other, beside] : touches) {
        if (other != target && !flight.touches(other) && !flight.bounces(other, beside)) {
            touch.push += std::exchange(beside.push, glm::vec3(0.0f));
        }
    }
    const glm::vec3 now = fromBullet(flight.body->getLinearVelocity());
    if (missed && (touch.push == glm::vec3(0.0f) || glm::dot(now, touch.deepest.normal) < 0.0f)) {
        // Bullet found no contact where the sweep did.
        bounce(flight, targets.at(target), touch);
    }
}

/// What a target pushed it with that it does not touch: braked by it, it would glide off along the tangent
/// plane and never come to the surface. The sweep found the way free.
void PhysicsWorld::Private::takeBack(Flight& flight, TargetId target, Touch& touch) const {
    const glm::vec3 change = std::exchange(touch.push, glm::vec3(0.0f)) / flight.settings.mass;
    if (flight.touches(target)) {
        return;  // it rolls there
    }
    btRigidBody& body = *flight.body;
    body.setLinearVelocity(body.getLinearVelocity() - toBullet(change));
    moveTo(body,
           fromBullet(body.getWorldTransform().getOrigin()) - change * static_cast<float>(clock.step()));
}

/// `touched`: the projectile's own.
void PhysicsWorld::Private::collect(ProjectileId id, Flight& flight, std::span<const TouchEntry> touched) {
    if (touched.empty() && !flight.strike) {
        flight.touching.clear();
        return;
    }
    std::map<TargetId, Touch> touches;
    for (const TouchEntry& entry : touched) {
        Touch& touch = touches.emplace(entry.target, entry.touch).first->second;
        // Bullet brakes at once what moves along the tangent plane of a surface that it never comes to. What
        // moves itself may have come.
        if (flight.meetsNothing && touch.distance > 0.0f && !targets.at(entry.target).physics.isDynamic) {
            takeBack(flight, entry.target, touch);
        }
    }
    std::vector<TargetId> touching;
    for (const auto& [target, touch] : touches) {
        // What it only comes near it may strike in the next step.
        if (touch.push != glm::vec3(0.0f) || flight.touches(target)) {
            touching.push_back(target);
        }
    }
    if (flight.strike) {
        settleStrike(flight, touches);
        strike(id, flight, flight.strike->target, touches.at(flight.strike->target));
    }
    for (const auto& [target, touch] : touches) {
        if (!flight.strikes(target) && !flight.touches(target) && touch.push != glm::vec3(0.0f)) {
            strike(id, flight, target, touch);
        }
    }
    if (flight.strike && !std::binary_search(touching.begin(), touching.end(), flight.strike->target)) {
        touching.push_back(flight.strike->target);
        std::sort(touching.begin(), touching.end());
    }
    flight.touching = std::move(touching);
}

/// From above the floor carries it.
void PhysicsWorld::Private::comeUp(Flight& flight) const {
    if (flight.isUnderFloor && (!floor || flight.position.y >= floorShape->getPlaneConstant())) {
        flight.isUnderFloor = false;
        flight.body->getBroadphaseProxy()->m_collisionFilterMask = btBroadphaseProxy::AllFilter;
    }
}

void PhysicsWorld::Private::followDynamicTargets() {
    for (auto& [id, target] : targets) {
        if (target.physics.isDynamic) {
            const btTransform& where = target.body->getWorldTransform();
            target.transform.rotation = glm::normalize(fromBullet(where.getRotation()));
            target.transform.position =
                fromBullet(where.getOrigin()) - target.transform.rotation * target.shape->centre();
        }
    }
}

void PhysicsWorld::Private::removeSpentFlights() {
    for (auto it = flights.begin(); it != flights.end();) {
        const auto current = it++;
        const glm::vec3 position = fromBullet(current->second.body->getWorldTransform().getOrigin());
        if (clock.time() >= current->second.end || !isUsable(position)) {
            removeFlight(current);
        }
    }
}

void PhysicsWorld::Private::keepTrails() {
    const double apart = kTrailSeconds / static_cast<double>(Flight::kTrailPoints);
    const std::int64_t every = std::max<std::int64_t>(1, std::llround(apart / clock.step()));
    if ((clock.steps() + 1) % every == 0) {
        for (auto& [id, flight] : flights) {
            flight.keepTrail();
        }
    }
}

/// What is slow for the paper's projectile is fast for one of a micrometre.
void PhysicsWorld::Private::letBounceSlowly() {
    float size = 1.0f;
    for (const auto& [id, flight] : flights) {
        size = std::min(size, sizeOf(flight.settings));
    }
    world.getSolverInfo().m_restitutionVelocityThreshold = kLeastRestitution * size;
}

/// Returns whether there is anything to move.
bool PhysicsWorld::Private::beginStep() {
    bool isMoving = !flights.empty();
    for (auto& [id, target] : targets) {
        target.previous = target.transform;
        isMoving = isMoving || target.physics.isDynamic;
    }
    if (!isMoving) {
        return false;
    }
    for (auto& [id, flight] : flights) {
        flight.previous = flight.position;
    }
    followHulls();
    surfaces = surfacesNow(Use::Motion);
    nextToApproach = {};
    return true;
}

bool PhysicsWorld::Private::approachAll(const IsTimeUp& isTimeUp) {
    for (auto it = flights.lower_bound(nextToApproach); it != flights.end();) {
        approach(it->first, it->second);
        touchAhead(it->second);
        nextToApproach = {it->first.value + 1};
        ++it;
        if (isTimeUp && isTimeUp()) {
            return false;  // after the last one, too: what comes next takes a while
        }
    }
    return true;
}

void PhysicsWorld::Private::endStep() {
    clock.count();
    collectTouches(dispatcher, contacts);
    auto next = contacts.cbegin();
    for (auto& [id, flight] : flights) {
        const auto first = next;
        while (next != contacts.cend() && next->projectile == id) {
            ++next;
        }
        collect(id, flight, {first, next});
        flight.position = fromBullet(flight.body->getWorldTransform().getOrigin());
        comeUp(flight);
    }
    followDynamicTargets();
    removeSpentFlights();
}

bool PhysicsWorld::Private::step(const IsTimeUp& isTimeUp) {
    if (part == StepPart::None) {
        if (!beginStep()) {
            clock.count();
            return true;
        }
        part = StepPart::Approach;
    }
    if (part == StepPart::Approach) {
        if (!approachAll(isTimeUp)) {
            return false;
        }
        part = StepPart::Solve;
    }
    if (part == StepPart::Solve) {
        keepTrails();
        letBounceSlowly();
        world.stepSimulation(static_cast<btScalar>(clock.step()), 0);
        part = StepPart::Move;
        if (isTimeUp && isTimeUp()) {
            return false;
        }
    }
    if (!world.move(isTimeUp)) {
        return false;
    }
    endStep();
    part = StepPart::None;
    return true;
}

void PhysicsWorld::Private::finishStep() {
    if (part != StepPart::None) {
        isStepToTake = step({});
    }
}

}  // namespace hitscope
