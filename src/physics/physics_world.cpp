// SPDX-License-Identifier: GPL-3.0-or-later
// Targets, the floor, the clock.
#include "physics/physics_world.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "physics/bullet_conversions.h"
#include "physics/world_private.h"

namespace hitscope {

using namespace physics;

namespace {

constexpr float kLargestDynamic = 1.0e5f;  // metres: Bullet drops moving bodies whose box is much larger

/// `transform` with a rotation of unit length.
Result<RigidTransform> usablePlace(const RigidTransform& transform) {
    const float turn = glm::length(transform.rotation);
    if (!isUsable(transform.position) || !(turn > 0.0f) || !std::isfinite(turn)) {
        return Error{"The target's place is not a number, or farther than 10,000 km from the origin.", "",
                     "Put it nearer to the origin."};
    }
    return RigidTransform{transform.position, transform.rotation / turn};
}

Status checkDynamic(const CollisionShape& shape, const TargetPhysics& physics) {
    if (physics.isDynamic && !(shape.bounds().diagonal() <= kLargestDynamic)) {
        return Error{"The target is too large to be dynamic: more than 100 km across.", "",
                     "Leave it static, or scale it down."};
    }
    return Done{};
}

/// Bullet's plane reaches everywhere and is paired with everything; this one only with what is not above it.
class FloorShape : public btStaticPlaneShape {
public:
    explicit FloorShape(float y) : btStaticPlaneShape(btVector3(0, 1, 0), y) {}
    void getAabb(const btTransform& where, btVector3& low, btVector3& high) const override {
        btStaticPlaneShape::getAabb(where, low, high);
        high.setY(where.getOrigin().y() + getPlaneConstant());
    }
};

void setMotion(btRigidBody& body, btCollisionShape& shape, const TargetPhysics& physics) {
    btVector3 inertia(0, 0, 0);
    const float mass = physics.isDynamic ? physics.mass : 0.0f;
    if (physics.isDynamic) {
        shape.calculateLocalInertia(mass, inertia);
    }
    body.setMassProps(mass, inertia);
    body.updateInertiaTensor();
    body.setFriction(physics.friction);
    body.setRollingFriction(kRollingFriction);
    body.setRestitution(physics.restitution);
}

}  // namespace

void TargetBody::place() {
    previous = transform;
    const btTransform where(toBullet(transform.rotation), toBullet(transform.toWorld(shape->centre())));
    body->setWorldTransform(where);
    body->setInterpolationWorldTransform(where);
    body->setLinearVelocity(btVector3(0, 0, 0));
    body->setAngularVelocity(btVector3(0, 0, 0));
}

PhysicsWorld::Private::Private() {
    world.setGravity(btVector3(0, -kEarthGravity, 0));
    broadphase.getOverlappingPairCache()->setOverlapFilterCallback(&volleyFilter);
    broadphase.m_deferedcollide = true;
    // Contacts are solved in the order of the bodies, not of the tree that found them, whose shape remembers
    // in which order boxes moved.
    world.getDispatchInfo().m_deterministicOverlappingPairs = true;
    // What moves far is stopped by SteppedWorld: boxes around whole motions would only pair up projectiles
    // that fly side by side.
    world.getDispatchInfo().m_useContinuous = false;
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

void PhysicsWorld::Private::wakeAll() {
    for (auto& [id, flight] : flights) {
        flight.body->activate(true);
    }
    for (auto& [id, target] : targets) {
        if (target.physics.isDynamic) {
            target.body->activate(true);
        }
    }
}

/// Bullet sorts a body into static and dynamic ones when it is added, and keeps what it knows of its shape.
void PhysicsWorld::Private::addBody(TargetBody& target) {
    target.body->setCollisionShape(target.shape->bullet());
    setMotion(*target.body, *target.shape->bullet(), target.physics);
    world.addRigidBody(target.body.get());
}

PhysicsWorld::PhysicsWorld() : d(std::make_unique<Private>()) {}
PhysicsWorld::~PhysicsWorld() = default;

// Targets

Status PhysicsWorld::addTarget(TargetId target, const RigidTransform& transform, const Collider& collider,
                               const TargetPhysics& physics) {
    d->finishStep();
    removeTarget(target);
    const Result<RigidTransform> place = usablePlace(transform);
    if (!place) {
        return place.error();
    }
    Result<std::unique_ptr<CollisionShape>> shape = CollisionShape::make(collider);
    if (!shape) {
        return shape.error();
    }
    if (Status status = checkDynamic(*shape.value(), physics); !status) {
        return status;
    }
    TargetBody entry;
    entry.transform = place.value();
    entry.physics = clamped(physics);
    entry.shape = std::move(shape).value();
    const btRigidBody::btRigidBodyConstructionInfo info(0.0f, nullptr, entry.shape->bullet());
    entry.body = std::make_unique<btRigidBody>(info);
    entry.body->setUserIndex(static_cast<int>(BodyKind::Target));
    entry.body->setUserIndex2(static_cast<int>(target.value));
    entry.place();
    d->addBody(d->targets.emplace(target, std::move(entry)).first->second);
    d->wakeAll();
    return Done{};
}

void PhysicsWorld::removeTarget(TargetId target) {
    d->finishStep();
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

bool PhysicsWorld::hasTarget(TargetId target) const {
    return d->targets.contains(target);
}

Status PhysicsWorld::moveTarget(TargetId target, const RigidTransform& transform) {
    d->finishStep();
    const Result<RigidTransform> place = usablePlace(transform);
    if (!place) {
        return place.error();
    }
    const auto found = d->targets.find(target);
    if (found != d->targets.end()) {
        found->second.transform = place.value();
        found->second.place();
        d->world.updateSingleAabb(found->second.body.get());
        d->wakeAll();
    }
    return Done{};
}

Status PhysicsWorld::setTargetPhysics(TargetId target, const TargetPhysics& physics) {
    d->finishStep();
    const auto found = d->targets.find(target);
    if (found == d->targets.end()) {
        return Done{};
    }
    TargetBody& entry = found->second;
    if (Status status = checkDynamic(*entry.shape, physics); !status) {
        return status;
    }
    entry.physics = clamped(physics);
    d->world.removeRigidBody(entry.body.get());
    entry.place();
    d->addBody(entry);
    d->wakeAll();
    return Done{};
}

void PhysicsWorld::updateTarget(TargetId target, std::uint32_t first,
                                std::span<const DynamicVertex> vertices) {
    d->finishStep();
    const auto found = d->targets.find(target);
    if (found != d->targets.end()) {
        TargetBody& body = found->second;
        if (body.asked) {
            body.asked->update(first, vertices);
        }
        d->reshape(target, body, body.shape->update(first, vertices));
    }
}

void PhysicsWorld::updateForQuestions(TargetId target, std::uint32_t first,
                                      std::span<const DynamicVertex> vertices) {
    const auto found = d->targets.find(target);
    if (found != d->targets.end()) {
        TargetBody& body = found->second;
        if (!body.asked) {
            body.asked = body.shape->copy();
        }
        body.asked->update(first, vertices);
    }
}

void PhysicsWorld::answerFromWhatIsHit(TargetId target) {
    if (const auto found = d->targets.find(target); found != d->targets.end()) {
        found->second.asked.reset();
    }
}

void PhysicsWorld::resetTarget(TargetId target) {
    d->finishStep();
    const auto found = d->targets.find(target);
    if (found != d->targets.end()) {
        found->second.asked.reset();
        d->reshape(target, found->second, found->second.shape->reset());
    }
}

void PhysicsWorld::Private::reshape(TargetId id, TargetBody& target, const CollisionShape::Change& change) {
    if (!change.moved) {
        return;
    }
    wakeWhatTouches(id, target);
    if (change.isAnother) {
        const btVector3 velocity = target.body->getLinearVelocity();
        const btVector3 spin = target.body->getAngularVelocity();
        world.removeRigidBody(target.body.get());
        addBody(target);
        target.body->setLinearVelocity(velocity);
        target.body->setAngularVelocity(spin);
    } else {
        world.updateSingleAabb(target.body.get());
    }
    target.hullIsOld = true;
    if (target.physics.isDynamic) {
        target.body->activate(true);
    }
}

std::vector<TargetPose> PhysicsWorld::dynamicTargets() const {
    std::vector<TargetPose> states;
    for (const auto& [id, target] : d->targets) {
        if (target.physics.isDynamic) {
            const RigidTransform& from = target.previous;
            const RigidTransform& to = target.transform;
            const float t = d->clock.between();
            states.push_back({id,
                              to,
                              {glm::mix(from.position, to.position, t),
                               glm::normalize(glm::slerp(from.rotation, to.rotation, t))}});
        }
    }
    return states;
}

void PhysicsWorld::setFloor(float y) {
    removeFloor();
    if (!(std::abs(y) <= kFarthest)) {
        return;
    }
    d->floorShape = std::make_unique<FloorShape>(y);
    const btRigidBody::btRigidBodyConstructionInfo info(0.0f, nullptr, d->floorShape.get());
    d->floor = std::make_unique<btRigidBody>(info);
    d->floor->setUserIndex(static_cast<int>(BodyKind::Floor));
    d->floor->setUserIndex2(0);
    d->floor->setRestitution(kRestitution);
    d->floor->setFriction(kFriction);
    d->floor->setRollingFriction(kRollingFriction);
    d->world.addRigidBody(d->floor.get(), kFloorGroup, btBroadphaseProxy::DefaultFilter);
    d->wakeAll();
}

void PhysicsWorld::removeFloor() {
    d->finishStep();
    if (d->floor) {
        d->world.removeRigidBody(d->floor.get());
        d->floor.reset();
        d->floorShape.reset();
        d->wakeAll();
    }
}

// Time

StepClock& PhysicsWorld::clock() {
    return d->clock;
}

const StepClock& PhysicsWorld::clock() const {
    return d->clock;
}

std::optional<std::vector<Impact>> PhysicsWorld::takeStep(const IsTimeUp& isTimeUp) {
    if (!d->isStepToTake && !d->step(isTimeUp)) {
        return std::nullopt;
    }
    d->isStepToTake = false;
    return std::exchange(d->impacts, {});
}

std::vector<Impact> PhysicsWorld::takeStep() {
    return takeStep({}).value_or(std::vector<Impact>());
}

bool PhysicsWorld::isMidStep() const {
    return d->isStepToTake || d->part != Private::StepPart::None;
}

std::vector<Impact> PhysicsWorld::advance(double seconds) {
    std::vector<Impact> impacts;
    for (int steps = d->clock.stepsDue(seconds); steps > 0; --steps) {
        const std::vector<Impact> some = takeStep();
        impacts.insert(impacts.end(), some.begin(), some.end());
    }
    return impacts;
}

std::vector<Impact> PhysicsWorld::stepOnce() {
    std::vector<Impact> impacts = takeStep();
    d->clock.showLastStep();
    return impacts;
}

bool PhysicsWorld::isMoving() const {
    return !d->flights.empty() || std::any_of(d->targets.begin(), d->targets.end(), [](const auto& entry) {
        return entry.second.physics.isDynamic && entry.second.body->isActive();
    });
}

}  // namespace hitscope
