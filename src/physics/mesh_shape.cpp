// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/mesh_shape.h"

#include <BulletCollision/CollisionShapes/btTriangleCallback.h>
#include <LinearMath/btAabbUtil2.h>

#include <algorithm>
#include <utility>

#include "physics/bullet_conversions.h"

namespace hitscope::physics {
namespace {

const btVector3 kUnscaled(1, 1, 1);

}  // namespace

MeshShape::MeshShape(std::shared_ptr<const CollisionMesh> original, const glm::vec3& centre)
    : m_surface(std::move(original)), m_centre(centre), m_outermost(*m_surface.original().hull()) {
    m_shapeType = CUSTOM_CONCAVE_SHAPE_TYPE;
    m_collisionMargin = 0.0f;
    makeHull(m_outermost.points());
    m_hull->calculateLocalInertia(1.0f, m_inertia);
}

void MeshShape::makeHull(std::vector<glm::vec3> points) {
    m_hull = std::make_unique<btConvexHullShape>();
    for (const glm::vec3& point : points) {
        m_hull->addPoint(toBullet(point - m_centre), false);
    }
    m_hull->recalcLocalAabb();
    m_hull->setMargin(std::min(0.001f, 0.01f * m_surface.original().bounds().diagonal()));
    m_hullPoints = std::move(points);
}

bool MeshShape::followSurface() {
    m_surface.update(m_outermost);
    std::vector<glm::vec3> points = m_outermost.points();
    if (points == m_hullPoints) {
        return false;
    }
    makeHull(std::move(points));
    return true;
}

void MeshShape::getAabb(const btTransform& transform, btVector3& low, btVector3& high) const {
    const Bounds bounds = m_surface.bounds();
    btTransformAabb(toBullet(bounds.min - m_centre), toBullet(bounds.max - m_centre), m_hull->getMargin(),
                    transform, low, high);
}

void MeshShape::processAllTriangles(btTriangleCallback* callback, const btVector3& low,
                                    const btVector3& high) const {
    const Bounds box{fromBullet(low) + m_centre, fromBullet(high) + m_centre};
    m_surface.visitWithin(box, [&](std::uint32_t index, const Triangle& triangle) {
        btVector3 corners[3] = {toBullet(glm::vec3(triangle.a) - m_centre),
                                toBullet(glm::vec3(triangle.b) - m_centre),
                                toBullet(glm::vec3(triangle.c) - m_centre)};
        callback->processTriangle(corners, 0, static_cast<int>(index));
    });
}

void MeshShape::setLocalScaling(const btVector3& /*scaling*/) {}

const btVector3& MeshShape::getLocalScaling() const {
    return kUnscaled;
}

void MeshShape::calculateLocalInertia(btScalar mass, btVector3& inertia) const {
    inertia = m_inertia * mass;
}

}  // namespace hitscope::physics
