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
    for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
        btRigidBody& body = *m_nonStaticRigidBodies[i];
        if (!body.isActive() || body.isStaticOrKinematicObject()) {
            continue;
        }
        btTransform predicted;
        body.predictIntegratedTransform(seconds, predicted);
        if (isKind(body, BodyKind::Projectile)) {
            stopAtFirst(m_scene, body, predicted);
        }
        body.proceedToTransform(predicted);
    }
}

}  // namespace hitscope::physics
