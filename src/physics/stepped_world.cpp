// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/stepped_world.h"

#include <glm/geometric.hpp>

#include "physics/bullet_conversions.h"
#include "physics/motion_sweep.h"

namespace hitscope::physics {
namespace {

/// Less than this, in radii, cannot carry a sphere's centre through a surface.
constexpr float kShortMotion = 0.5f;

void stopAtFirst(const SweepScene& scene, const btRigidBody& body, btTransform& predicted) {
    const float radius = static_cast<const btSphereShape*>(body.getCollisionShape())->getRadius();
    const glm::vec3 from = fromBullet(body.getWorldTransform().getOrigin());
    const glm::vec3 motion = fromBullet(predicted.getOrigin()) - from;
    if (glm::length(motion) <= kShortMotion * radius) {
        return;
    }
    if (const auto contact = scene.sweep(from, motion, radius)) {
        predicted.setOrigin(toBullet(from + motion * static_cast<float>(contact->fraction)));
    }
}

}  // namespace

void SteppedWorld::integrateTransforms(btScalar seconds) {
    m_seconds = seconds;
    m_toMove.clear();
    for (int i = m_nonStaticRigidBodies.size() - 1; i >= 0; --i) {
        btRigidBody& body = *m_nonStaticRigidBodies[i];
        if (body.isActive() && !body.isStaticOrKinematicObject()) {
            m_toMove.push_back(&body);
        }
    }
}

bool SteppedWorld::move(const IsTimeUp& isTimeUp) {
    while (!m_toMove.empty()) {
        btRigidBody& body = *m_toMove.back();
        m_toMove.pop_back();
        btTransform predicted;
        body.predictIntegratedTransform(m_seconds, predicted);
        if (isKind(body, BodyKind::Projectile)) {
            stopAtFirst(m_scene, body, predicted);
        }
        body.proceedToTransform(predicted);
        if (!m_toMove.empty() && isTimeUp && isTimeUp()) {
            break;
        }
    }
    return m_toMove.empty();
}

}  // namespace hitscope::physics
