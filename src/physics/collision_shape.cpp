// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/collision_shape.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>

#include <algorithm>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <limits>

#include "physics/bullet_conversions.h"

namespace hitscope::physics {
namespace {

// Bullet rounds a box's corners by its margin: far below anything one can see, yet not zero, which GJK does
// not like between two polyhedra.
constexpr float kLargestMargin = 0.001f;
// Bullet's quantized tree keeps a triangle's index in 21 bits.
constexpr std::size_t kMostQuantizedTriangles = (std::size_t{1} << 21u) - 1;

bool hasArea(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::vec3 ab = b - a;
    const glm::vec3 ac = c - a;
    const float longest = std::max(glm::dot(ab, ab), glm::dot(ac, ac));
    const glm::vec3 normal = glm::cross(ab, ac);
    return glm::dot(normal, normal) > 1.0e-12f * longest * longest;
}

/// The mesh without what Bullet cannot use: indices out of range, corners not finite, triangles without area.
MeshCollider usableTriangles(const MeshCollider& mesh) {
    MeshCollider usable;
    usable.vertices = mesh.vertices;
    for (glm::vec3& vertex : usable.vertices) {
        if (!isUsable(vertex)) {
            vertex = glm::vec3(std::numeric_limits<float>::quiet_NaN());
        }
    }
    usable.triangles.reserve(mesh.triangles.size());
    const std::size_t count = usable.vertices.size();
    for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
        const std::uint32_t* t = &mesh.triangles[i];
        // A NaN corner makes the area NaN, which is not greater than anything.
        if (t[0] < count && t[1] < count && t[2] < count &&
            hasArea(usable.vertices[t[0]], usable.vertices[t[1]], usable.vertices[t[2]])) {
            usable.triangles.insert(usable.triangles.end(), t, t + 3);
        }
    }
    return usable;
}

/// Ericson, Real-Time Collision Detection, 5.1.5: the Voronoi region of the triangle that `p` lies in.
glm::vec3 nearestOnTriangle(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::vec3 ab = b - a;
    const glm::vec3 ac = c - a;
    const float d1 = glm::dot(ab, p - a);
    const float d2 = glm::dot(ac, p - a);
    if (d1 <= 0.0f && d2 <= 0.0f) {
        return a;
    }
    const float d3 = glm::dot(ab, p - b);
    const float d4 = glm::dot(ac, p - b);
    if (d3 >= 0.0f && d4 <= d3) {
        return b;
    }
    const float vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0f && d1 >= 0.0f && d3 <= 0.0f) {
        return a + ab * (d1 / (d1 - d3));
    }
    const float d5 = glm::dot(ab, p - c);
    const float d6 = glm::dot(ac, p - c);
    if (d6 >= 0.0f && d5 <= d6) {
        return c;
    }
    const float vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0f && d2 >= 0.0f && d6 <= 0.0f) {
        return a + ac * (d2 / (d2 - d6));
    }
    const float va = d3 * d6 - d5 * d4;
    if (va <= 0.0f && d4 >= d3 && d5 >= d6) {
        return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    }
    const float scale = 1.0f / (va + vb + vc);
    return a + ab * (vb * scale) + ac * (vc * scale);
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

CollisionShape::CollisionShape(const Collider& collider) {
    if (const auto* box = std::get_if<BoxCollider>(&collider)) {
        const float smallest = std::min({box->halfExtent.x, box->halfExtent.y, box->halfExtent.z});
        if (isUsable(box->halfExtent) && smallest > 0.0f) {
            m_collider = *box;
            m_shape = std::make_unique<btBoxShape>(toBullet(box->halfExtent));
            m_shape->setMargin(std::min(kLargestMargin, 0.1f * smallest));
        }
    } else if (const auto* sphere = std::get_if<SphereCollider>(&collider)) {
        if (sphere->radius > 0.0f && sphere->radius <= kFarthest) {
            m_collider = *sphere;
            m_shape = std::make_unique<btSphereShape>(sphere->radius);
        }
    } else {
        makeMesh(std::get<MeshCollider>(collider));
    }
}

void CollisionShape::makeMesh(const MeshCollider& mesh) {
    auto& kept = m_collider.emplace<MeshCollider>(usableTriangles(mesh));
    if (kept.triangles.empty()) {
        return;
    }
    // The tree's bounds are taken over triangles only, so vertices that none of them uses may stay NaN.
    btIndexedMesh part;
    part.m_numTriangles = static_cast<int>(kept.triangles.size() / 3);
    part.m_triangleIndexBase = reinterpret_cast<const unsigned char*>(kept.triangles.data());
    part.m_triangleIndexStride = 3 * sizeof(std::uint32_t);
    part.m_numVertices = static_cast<int>(kept.vertices.size());
    part.m_vertexBase = reinterpret_cast<const unsigned char*>(kept.vertices.data());
    part.m_vertexStride = sizeof(glm::vec3);
    part.m_vertexType = PHY_FLOAT;
    m_arrays = std::make_unique<btTriangleIndexVertexArray>();
    m_arrays->addIndexedMesh(part, PHY_INTEGER);
    const bool quantized = kept.triangles.size() / 3 <= kMostQuantizedTriangles;
    m_shape = std::make_unique<btBvhTriangleMeshShape>(m_arrays.get(), quantized);
}

std::unique_ptr<CollisionShape> CollisionShape::make(const Collider& collider) {
    std::unique_ptr<CollisionShape> shape(new CollisionShape(collider));
    return shape->m_shape ? std::move(shape) : nullptr;
}

std::optional<SurfacePoint> CollisionShape::nearest(const glm::vec3& from, int triangle) const {
    if (const auto* sphere = std::get_if<SphereCollider>(&m_collider)) {
        const glm::vec3 normal = unitOr(from, glm::vec3(0, 1, 0));
        return SurfacePoint{normal * sphere->radius, normal};
    }
    if (const auto* box = std::get_if<BoxCollider>(&m_collider)) {
        const glm::vec3 point = nearestOnBox(from, box->halfExtent);
        const bool inside = glm::all(glm::lessThanEqual(glm::abs(from), box->halfExtent));
        const glm::vec3 outwards = inside ? point - from : from - point;
        return SurfacePoint{point, unitOr(outwards, unitOr(from, glm::vec3(0, 1, 0)))};
    }
    const auto& mesh = std::get<MeshCollider>(m_collider);
    if (triangle < 0 || static_cast<std::size_t>(triangle) >= mesh.triangles.size() / 3) {
        return std::nullopt;
    }
    const std::uint32_t* t = &mesh.triangles[3 * static_cast<std::size_t>(triangle)];
    const glm::vec3& a = mesh.vertices[t[0]];
    const glm::vec3& b = mesh.vertices[t[1]];
    const glm::vec3& c = mesh.vertices[t[2]];
    const glm::vec3 point = nearestOnTriangle(from, a, b, c);
    return SurfacePoint{point, unitOr(from - point, glm::normalize(glm::cross(b - a, c - a)))};
}

}  // namespace hitscope::physics
