// SPDX-License-Identifier: GPL-3.0-or-later
// The session's targets as the physics has them.
#include <utility>

#include "session/session.h"
#include "session/simulation.h"

namespace hitscope {

void Simulation::followDynamicTargets() {
    for (const TargetPose& pose : m_physics.dynamicTargets()) {
        m_session.m_targets.moveTo(pose.id, pose.drawn);
    }
}

std::vector<TargetPlace> Simulation::dynamicPlaces() const {
    std::vector<TargetPlace> places;
    for (const TargetPose& pose : m_physics.dynamicTargets()) {
        places.push_back({pose.id, pose.transform});
    }
    return places;
}

void Simulation::putBack(std::span<const TargetPlace> places) {
    for (const TargetPlace& place : places) {
        const Target* target = m_session.m_targets.find(place.id);
        if (target != nullptr && target->physics.isDynamic &&
            m_physics.moveTarget(place.id, place.transform)) {
            m_session.m_targets.moveTo(place.id, place.transform);
        }
    }
}

void Simulation::shapeAt(std::span<const TargetPlace> places) {
    for (const TargetPlace& place : places) {
        m_colliders.hurry(place.id);
    }
}

void Simulation::clear() {
    for (const std::unique_ptr<Target>& target : m_session.m_targets) {
        m_physics.removeTarget(target->id);
    }
    m_physics.removeProjectiles();
    cancelScheduled();
    m_tally.clear();
    m_colliders.clear();
    m_stepIsBegun = false;
    m_notHittable.clear();
    m_held.clear();
}

void Simulation::setFloor(float height) {
    m_physics.setFloor(height);
}

void Simulation::add(const Target& target) {
    m_colliders.add(target.id, target.shape.render);
    letCollide(target);
}

void Simulation::forget(TargetId target) {
    m_physics.removeTarget(target);
    m_colliders.forget(target);
    m_notHittable.erase(target);
    m_held.erase(target);
}

void Simulation::hold(std::span<const TargetId> ids) {
    std::set<TargetId> changed = std::exchange(m_held, std::set<TargetId>(ids.begin(), ids.end()));
    changed.insert(ids.begin(), ids.end());
    for (const TargetId id : changed) {
        const Target* target = m_session.m_targets.find(id);
        if (target != nullptr && target->visible && target->physics.isDynamic) {
            letCollide(*target);
        }
    }
}

TargetPhysics Simulation::physicsOf(const Target& target) const {
    TargetPhysics physics = target.physics;
    physics.isDynamic = physics.isDynamic && !m_held.contains(target.id);
    return physics;
}

void Simulation::letCollide(const Target& target) {
    m_notHittable.erase(target.id);
    if (!target.visible) {
        m_physics.removeTarget(target.id);
        return;
    }
    const bool isNew = !m_physics.hasTarget(target.id);
    Status status =
        isNew ? m_physics.addTarget(target.id, target.transform, *target.collider, physicsOf(target))
              : m_physics.moveTarget(target.id, target.transform);
    if (status && !isNew) {
        status = m_physics.setTargetPhysics(target.id, physicsOf(target));
    }
    if (!status) {
        m_physics.removeTarget(target.id);
        m_notHittable[target.id] = QString::fromStdString(status.error().message());
        return;
    }
    if (isNew) {
        m_colliders.restore(target.id);
    }
}

Status Simulation::setTargetPhysics(TargetId id, const TargetPhysics& physics) {
    return m_physics.setTargetPhysics(id, physics);
}

QString Simulation::whyNotHittable(TargetId id) const {
    const auto reason = m_notHittable.find(id);
    return reason == m_notHittable.end() ? QString() : reason->second;
}

}  // namespace hitscope
