// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/collision_shape.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "physics/bullet_conversions.h"

namespace hitscope::physics {
namespace {

// Bullet rounds a box's corners by its margin: far below anything one can see, yet not zero, which GJK does
// not like between two polyhedra.
constexpr float kLargestMargin = 0.001f;

Error noSize(const char* what) {
    return {std::string("The ") + what + " has no size, or one that is not a number or too large.", "",
            "Give it a size above zero and below 10,000 km."};
}

/// The twelve triangles of a box: what a sphere that sweeps past corners and edges needs, exactly.
std::array<Triangle, 12> boxTriangles(const glm::vec3& halfExtent) {
    std::array<Triangle, 12> triangles;
    std::size_t next = 0;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            const auto corner = [&](double u, double v) {
                glm::dvec3 p(halfExtent);
                p[axis] *= side;
                p[(axis + 1) % 3] *= u;
                p[(axis + 2) % 3] *= v;
                return p;
            };
            triangles[next++] = {corner(-1, -1), corner(1, -1), corner(1, 1)};
            triangles[next++] = {corner(-1, -1), corner(1, 1), corner(-1, 1)};
        }
    }
    return triangles;
}

std::optional<SurfaceCast> castAtBox(const glm::vec3& halfExtent, const glm::dvec3& start,
                                     const glm::dvec3& motion, double radius) {
    std::optional<SurfaceCast> first;
    for (const Triangle& triangle : boxTriangles(halfExtent)) {
        const auto fraction =
            radius > 0.0 ? castSphere(triangle, start, motion, radius) : castPoint(triangle, start, motion);
        if (fraction && (!first || *fraction < first->fraction)) {
            first = SurfaceCast{*fraction, -1};
        }
    }
    return first;
}

glm::vec3 nearestOnBox(const glm::vec3& p, const glm::vec3& halfExtent) {
    const glm::vec3 inside = glm::clamp(p, -halfExtent, halfExtent);
    if (inside != p) {
        return inside;
    }
    const glm::vec3 depth = halfExtent - glm::abs(p);
    const int axis = depth.x <= depth.y ? (depth.x <= depth.z ? 0 : 2) : (depth.y <= depth.z ? 1 : 2);
    glm::vec3 result = p;
    result[axis] = p[axis] < 0.0f ? -halfExtent[axis] : halfExtent[axis];
    return result;
}

glm::vec3 unitOr(const glm::vec3& v, const glm::vec3& fallback) {
    const float length = glm::length(v);
    return length > 1.0e-9f ? v / length : fallback;
}

}  // namespace

Result<std::unique_ptr<CollisionShape>> CollisionShape::make(const Collider& collider) {
    std::unique_ptr<CollisionShape> shape(new CollisionShape);
    Status status = Done{};
    if (const auto* box = std::get_if<BoxCollider>(&collider)) {
        status = shape->takeBox(*box);
    } else if (const auto* sphere = std::get_if<SphereCollider>(&collider)) {
        status = shape->takeSphere(*sphere);
    } else {
        status = shape->takeMesh(std::get<MeshCollider>(collider));
    }
    if (!status) {
        return status.error();
    }
    shape->m_collider = collider;
    return shape;
}

std::unique_ptr<CollisionShape> CollisionShape::copy() const {
    std::unique_ptr<CollisionShape> other = std::move(make(m_collider)).value();
    if (m_mesh) {
        other->m_mesh->surface() = MeshSurface(m_mesh->surface());
    }
    return other;
}

Status CollisionShape::takeBox(const BoxCollider& box) {
    const float smallest = std::min({box.halfExtent.x, box.halfExtent.y, box.halfExtent.z});
    if (!isUsable(box.halfExtent) || !(smallest > 0.0f)) {
        return noSize("box");
    }
    m_primitive = std::make_unique<btBoxShape>(toBullet(box.halfExtent));
    m_primitive->setMargin(std::min(kLargestMargin, 0.1f * smallest));
    prepareSurface(box.surface);
    return Done{};
}

Status CollisionShape::takeSphere(const SphereCollider& sphere) {
    if (!(sphere.radius > 0.0f) || !(sphere.radius <= kFarthest)) {
        return noSize("sphere");
    }
    m_primitive = std::make_unique<btSphereShape>(sphere.radius);
    prepareSurface(sphere.surface);
    return Done{};
}

Status CollisionShape::takeMesh(const MeshCollider& mesh) {
    if (!mesh.surface || !mesh.surface->hasSurface()) {
        return Error{"The mesh has no triangle with an area: nothing can hit it.", "",
                     "Check that its faces have three different corners that are not in a line."};
    }
    const Bounds bounds = mesh.surface->bounds();
    if (!isUsable(bounds.min) || !isUsable(bounds.max)) {
        return Error{"The mesh reaches farther than 10,000 km from its origin.", "",
                     "Move it nearer to the origin, or scale it down."};
    }
    m_centre = bounds.centre();
    prepareSurface(mesh.surface);
    return Done{};
}

void CollisionShape::prepareSurface(const std::shared_ptr<const CollisionMesh>& surface) {
    if (surface && surface->hasSurface()) {
        m_mesh = std::make_unique<MeshShape>(surface, m_centre);
    }
}

bool CollisionShape::usesMesh() const {
    return !m_primitive || (m_mesh && m_mesh->surface().isDented());
}

btCollisionShape* CollisionShape::bullet() const {
    return usesMesh() ? static_cast<btCollisionShape*>(m_mesh.get()) : m_primitive.get();
}

Bounds CollisionShape::bounds() const {
    if (usesMesh()) {
        return m_mesh->surface().bounds();
    }
    const auto* box = std::get_if<BoxCollider>(&m_collider);
    const glm::vec3 reach =
        box != nullptr ? box->halfExtent : glm::vec3(std::get<SphereCollider>(m_collider).radius);
    return {-reach, reach};
}

CollisionShape::Change CollisionShape::update(std::uint32_t first, std::span<const DynamicVertex> vertices) {
    const btCollisionShape* before = bullet();
    const bool moved = m_mesh && m_mesh->surface().update(first, vertices);
    return {moved, bullet() != before};
}

CollisionShape::Change CollisionShape::reset() {
    const btCollisionShape* before = bullet();
    const bool moved = m_mesh && m_mesh->surface().isDented();
    if (moved) {
        m_mesh->surface().reset();
    }
    return {moved, bullet() != before};
}

std::optional<SurfaceCast> CollisionShape::cast(const glm::dvec3& start, const glm::dvec3& motion,
                                                double radius) const {
    if (usesMesh()) {
        return m_mesh->surface().cast(start, motion, radius);
    }
    if (const auto* box = std::get_if<BoxCollider>(&m_collider)) {
        return castAtBox(box->halfExtent, start, motion, radius);
    }
    const double ball = static_cast<double>(std::get<SphereCollider>(m_collider).radius);
    const auto fraction = castAtBall(glm::dvec3(0.0), ball, start, motion, radius);
    return fraction ? std::optional(SurfaceCast{*fraction, -1}) : std::nullopt;
}

std::vector<std::uint32_t> CollisionShape::near(const glm::vec3& point, float distance) const {
    std::vector<std::uint32_t> found;
    if (m_mesh) {
        m_mesh->surface().visitNear(
            point, distance,
            [&found](std::uint32_t index, const Triangle& /*unused*/) { found.push_back(index); });
    }
    return found;
}

std::optional<SurfacePoint> CollisionShape::nearest(const glm::vec3& from, int triangle) const {
    if (usesMesh()) {
        const std::size_t count = m_mesh->surface().original().corners()->size() / 3;
        if (triangle < 0 || static_cast<std::size_t>(triangle) >= count) {
            return std::nullopt;
        }
        const Triangle struck = m_mesh->surface().triangle(static_cast<std::uint32_t>(triangle));
        const glm::dvec3 point = nearestPoint(struck, glm::dvec3(from));
        const glm::vec3 away(glm::dvec3(from) - point);
        return SurfacePoint{glm::vec3(point), unitOr(away, glm::vec3(struck.normal())), triangle};
    }
    if (const auto* sphere = std::get_if<SphereCollider>(&m_collider)) {
        const glm::vec3 normal = unitOr(from, glm::vec3(0, 1, 0));
        return SurfacePoint{normal * sphere->radius, normal, -1};
    }
    const glm::vec3 halfExtent = std::get<BoxCollider>(m_collider).halfExtent;
    const glm::vec3 point = nearestOnBox(from, halfExtent);
    const bool inside = glm::all(glm::lessThanEqual(glm::abs(from), halfExtent));
    const glm::vec3 outwards = inside ? point - from : from - point;
    return SurfacePoint{point, unitOr(outwards, unitOr(from, glm::vec3(0, 1, 0))), -1};
}

glm::vec3 CollisionShape::normalAt(const glm::vec3& point, int triangle) const {
    if (usesMesh()) {
        return glm::vec3(m_mesh->surface().triangle(static_cast<std::uint32_t>(triangle)).normal());
    }
    if (const auto* box = std::get_if<BoxCollider>(&m_collider)) {
        const glm::vec3 inside = box->halfExtent - glm::abs(point);
        const int axis =
            inside.x <= inside.y ? (inside.x <= inside.z ? 0 : 2) : (inside.y <= inside.z ? 1 : 2);
        glm::vec3 normal(0.0f);
        normal[axis] = point[axis] < 0.0f ? -1.0f : 1.0f;
        return normal;
    }
    return unitOr(point, glm::vec3(0, 1, 0));
}

}  // namespace hitscope::physics
