// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/motion_sweep.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseInterface.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "physics/bullet_conversions.h"

namespace hitscope::physics {
namespace {

class Query : public btBroadphaseRayCallback {
public:
    Query(const btCollisionObject* self, Meets meets, const glm::vec3& from, const glm::vec3& motion,
          float radius)
        : m_self(self),
          m_meets(meets),
          m_from(from),
          m_motion(motion),
          m_radius(static_cast<double>(radius)) {
        const btVector3 direction = toBullet(motion).normalized();
        for (int axis = 0; axis < 3; ++axis) {
            const bool isFlat = direction[axis] == 0.0f;
            m_rayDirectionInverse[axis] =
                isFlat ? static_cast<btScalar>(BT_LARGE_FLOAT) : 1.0f / direction[axis];
            m_signs[axis] = m_rayDirectionInverse[axis] < 0.0f ? 1u : 0u;
        }
        m_lambda_max = direction.dot(toBullet(motion));
    }

    bool process(const btBroadphaseProxy* proxy) override {
        const auto* body = static_cast<const btCollisionObject*>(proxy->m_clientObject);
        if (body == m_self) {
            return true;
        }
        std::optional<SurfaceCast> met;
        if (isKind(*body, BodyKind::Target)) {
            met = castAtTarget(*body);
        } else if (isKind(*body, BodyKind::Floor)) {
            met = castAtFloor(*body);
        } else if (m_meets == Meets::All) {
            met = castAtProjectile(*body);
        }
        if (met && (m_first.body == nullptr || met->fraction < m_first.fraction)) {
            m_first = {body, met->fraction, met->triangle};
        }
        return true;
    }

    [[nodiscard]] std::optional<SweepContact> first() const {
        return m_first.body != nullptr ? std::optional(m_first) : std::nullopt;
    }

private:
    [[nodiscard]] std::optional<SurfaceCast> castAtTarget(const btCollisionObject& body) const {
        const auto& shape = *static_cast<const CollisionShape*>(body.getUserPointer());
        const LocalFrame frame(body, shape);
        return shape.cast(frame.toLocal(m_from), frame.directionToLocal(m_motion), m_radius);
    }

    [[nodiscard]] std::optional<SurfaceCast> castAtFloor(const btCollisionObject& body) const {
        const auto& plane = static_cast<const btStaticPlaneShape&>(*body.getCollisionShape());
        const double height = m_from.y - static_cast<double>(plane.getPlaneConstant()) - m_radius;
        const bool isBelow = height + 2.0 * m_radius < 0.0;
        if (isBelow || m_motion.y >= 0.0 || height + m_motion.y > 0.0) {
            return std::nullopt;
        }
        return SurfaceCast{std::max(0.0, height / -m_motion.y), -1};
    }

    [[nodiscard]] std::optional<SurfaceCast> castAtProjectile(const btCollisionObject& body) const {
        const auto& ball = static_cast<const btSphereShape&>(*body.getCollisionShape());
        const glm::dvec3 centre(fromBullet(body.getWorldTransform().getOrigin()));
        const auto fraction =
            castAtBall(centre, static_cast<double>(ball.getRadius()), m_from, m_motion, m_radius);
        return fraction ? std::optional(SurfaceCast{*fraction, -1}) : std::nullopt;
    }

    const btCollisionObject* m_self;
    Meets m_meets;
    glm::dvec3 m_from;
    glm::dvec3 m_motion;
    double m_radius;
    SweepContact m_first;
};

}  // namespace

bool isKind(const btCollisionObject& body, BodyKind kind) {
    return body.getUserIndex() == static_cast<int>(kind);
}

LocalFrame::LocalFrame(const btCollisionObject& body, const CollisionShape& shape)
    : origin(fromBullet(body.getWorldTransform().getOrigin())), centre(shape.centre()) {
    for (int i = 0; i < 3; ++i) {
        rows[i] = glm::dvec3(fromBullet(body.getWorldTransform().getBasis().getRow(i)));
    }
}

glm::dvec3 LocalFrame::toLocal(const glm::dvec3& world) const {
    return directionToLocal(world - origin) + centre;
}

glm::dvec3 LocalFrame::directionToLocal(const glm::dvec3& world) const {
    return rows[0] * world.x + rows[1] * world.y + rows[2] * world.z;
}

std::optional<SweepContact> sweep(btBroadphaseInterface& broadphase, const btCollisionObject* self,
                                  Meets meets, const glm::vec3& from, const glm::vec3& motion, float radius) {
    if (!(glm::length(motion) > 0.0f)) {
        return std::nullopt;
    }
    Query query(self, meets, from, motion, radius);
    const btVector3 reach(radius, radius, radius);
    broadphase.rayTest(toBullet(from), toBullet(from + motion), query, -reach, reach);
    return query.first();
}

}  // namespace hitscope::physics
