// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/mesh_contacts.h"

#include <BulletCollision/CollisionDispatch/btActivatingCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <vector>

#include "physics/bullet_conversions.h"
#include "physics/contact_creation.h"
#include "physics/mesh_shape.h"

namespace hitscope::physics {
namespace {

constexpr std::size_t kMostContacts = 4;  // what one of Bullet's manifolds holds
// Contacts whose normals are nearer than this (a cosine: 18 degrees) say the same about a sphere.
constexpr double kSameSide = 0.95;

bool isMesh(const btCollisionObjectWrapper& body) {
    return body.getCollisionShape()->getShapeType() == CUSTOM_CONCAVE_SHAPE_TYPE;
}

const MeshShape& meshOf(const btCollisionObjectWrapper& body) {
    return static_cast<const MeshShape&>(*body.getCollisionShape());
}

/// The nearest contact first, then those that push to other sides.
std::vector<MeshContact> contactsOf(const MeshSurface& surface, const glm::dvec3& centre, double reach) {
    std::vector<MeshContact> near;
    const auto visit = [&](std::uint32_t index, const Triangle& triangle) {
        const glm::dvec3 point = nearestPoint(triangle, centre);
        const double distance = glm::length(centre - point);
        if (distance <= reach) {
            const glm::dvec3 normal = distance > 0.0 ? (centre - point) / distance : triangle.normal();
            near.push_back({point, normal, distance, index});
        }
    };
    surface.visitNear(glm::vec3(centre), static_cast<float>(reach), visit);
    const auto isNearer = [](const MeshContact& a, const MeshContact& b) {
        return a.distance != b.distance ? a.distance < b.distance : a.triangle < b.triangle;
    };
    std::vector<MeshContact> kept;
    while (!near.empty() && kept.size() < kMostContacts) {
        const MeshContact nearest = *std::min_element(near.begin(), near.end(), isNearer);
        kept.push_back(nearest);
        std::erase_if(near, [&nearest](const MeshContact& contact) {
            return glm::dot(contact.normal, nearest.normal) > kSameSide;
        });
    }
    return kept;
}

glm::dvec3 localCentre(const btTransform& ball, const btTransform& mesh, const MeshShape& shape) {
    return glm::dvec3(fromBullet(mesh.invXform(ball.getOrigin()))) + glm::dvec3(shape.centre());
}

/// Null: they were not worked out for just there.
const std::vector<MeshContact>* contactsAhead(const btCollisionObject& ball, const btCollisionObject& mesh,
                                              const glm::dvec3& centre, double reach) {
    if (const auto* all = static_cast<const std::vector<ContactsAhead>*>(ball.getUserPointer())) {
        for (const ContactsAhead& ahead : *all) {
            if (ahead.mesh == &mesh && ahead.centre == centre && ahead.reach == reach) {
                return &ahead.contacts;
            }
        }
    }
    return nullptr;
}

class SphereMesh : public btActivatingCollisionAlgorithm {
public:
    SphereMesh(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* a,
               const btCollisionObjectWrapper* b)
        : btActivatingCollisionAlgorithm(info, a, b) {
        m_manifold = m_dispatcher->getNewManifold(a->getCollisionObject(), b->getCollisionObject());
    }
    ~SphereMesh() override { m_dispatcher->releaseManifold(m_manifold); }
    SphereMesh(const SphereMesh&) = delete;
    SphereMesh& operator=(const SphereMesh&) = delete;

    void processCollision(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                          const btDispatcherInfo& /*info*/, btManifoldResult* result) override {
        const bool meshIsA = isMesh(*a);
        const btCollisionObjectWrapper& mesh = meshIsA ? *a : *b;
        const btCollisionObjectWrapper& ball = meshIsA ? *b : *a;
        const MeshShape& shape = meshOf(mesh);
        const btScalar radius = static_cast<const btSphereShape*>(ball.getCollisionShape())->getRadius();
        const btTransform& where = mesh.getWorldTransform();
        const glm::dvec3 centre = localCentre(ball.getWorldTransform(), where, shape);
        result->setPersistentManifold(m_manifold);
        // Made anew in each step: a contact kept from the last one would hold a sphere up where the surface
        // was before a dent.
        m_manifold->clearManifold();
        const double reach = radius + m_manifold->getContactBreakingThreshold();
        const std::vector<MeshContact>* ahead =
            contactsAhead(*ball.getCollisionObject(), *mesh.getCollisionObject(), centre, reach);
        const std::vector<MeshContact> now =
            ahead == nullptr ? contactsOf(shape.surface(), centre, reach) : std::vector<MeshContact>();
        for (const MeshContact& contact : ahead == nullptr ? now : *ahead) {
            const auto index = static_cast<int>(contact.triangle);
            const btVector3 normal = where.getBasis() * toBullet(glm::vec3(contact.normal));
            const btScalar depth = static_cast<btScalar>(contact.distance) - radius;
            if (meshIsA) {
                result->setShapeIdentifiersA(0, index);
                result->addContactPoint(-normal, ball.getWorldTransform().getOrigin() - normal * radius,
                                        depth);
            } else {
                const glm::vec3 point(contact.point - glm::dvec3(shape.centre()));
                result->setShapeIdentifiersB(0, index);
                result->addContactPoint(normal, where * toBullet(point), depth);
            }
        }
    }

    /// Bullet does not ask: its own continuous collision detection is off (see stepped_world.h).
    btScalar calculateTimeOfImpact(btCollisionObject* /*a*/, btCollisionObject* /*b*/,
                                   const btDispatcherInfo& /*info*/, btManifoldResult* /*result*/) override {
        return 1.0f;
    }
    void getAllContactManifolds(btManifoldArray& manifolds) override { manifolds.push_back(m_manifold); }

private:
    btPersistentManifold* m_manifold;
};

/// Hands a pair on to Bullet's algorithm for the convex hulls of the meshes in it.
class HullContacts : public btActivatingCollisionAlgorithm {
public:
    HullContacts(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* a,
                 const btCollisionObjectWrapper* b)
        : btActivatingCollisionAlgorithm(info, a, b) {
        const btCollisionObjectWrapper hullA = hullOf(*a);
        const btCollisionObjectWrapper hullB = hullOf(*b);
        m_algorithm = m_dispatcher->findAlgorithm(&hullA, &hullB, nullptr, BT_CONTACT_POINT_ALGORITHMS);
    }
    ~HullContacts() override {
        m_algorithm->~btCollisionAlgorithm();
        m_dispatcher->freeCollisionAlgorithm(m_algorithm);
    }
    HullContacts(const HullContacts&) = delete;
    HullContacts& operator=(const HullContacts&) = delete;

    void processCollision(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                          const btDispatcherInfo& info, btManifoldResult* result) override {
        const btCollisionObjectWrapper hullA = hullOf(*a);
        const btCollisionObjectWrapper hullB = hullOf(*b);
        result->setBody0Wrap(&hullA);
        result->setBody1Wrap(&hullB);
        m_algorithm->processCollision(&hullA, &hullB, info, result);
        result->setBody0Wrap(a);
        result->setBody1Wrap(b);
    }
    btScalar calculateTimeOfImpact(btCollisionObject* /*a*/, btCollisionObject* /*b*/,
                                   const btDispatcherInfo& /*info*/, btManifoldResult* /*result*/) override {
        return 1.0f;
    }
    void getAllContactManifolds(btManifoldArray& manifolds) override {
        m_algorithm->getAllContactManifolds(manifolds);
    }

private:
    static btCollisionObjectWrapper hullOf(const btCollisionObjectWrapper& body) {
        const btCollisionShape* shape = isMesh(body) ? &meshOf(body).hull() : body.getCollisionShape();
        return {&body, shape, body.getCollisionObject(), body.getWorldTransform(), -1, -1};
    }

    btCollisionAlgorithm* m_algorithm;
};

}  // namespace

void workOutContacts(const btCollisionObject& ball, const btCollisionObject& mesh,
                     std::vector<ContactsAhead>& ahead) {
    if (mesh.getCollisionShape()->getShapeType() != CUSTOM_CONCAVE_SHAPE_TYPE) {
        return;
    }
    const auto& shape = static_cast<const MeshShape&>(*mesh.getCollisionShape());
    const auto& sphere = static_cast<const btSphereShape&>(*ball.getCollisionShape());
    // As Bullet's dispatcher has it for the two.
    const btScalar near = std::min(sphere.getContactBreakingThreshold(gContactBreakingThreshold),
                                   shape.getContactBreakingThreshold(gContactBreakingThreshold));
    const double reach = sphere.getRadius() + near;
    const glm::dvec3 centre = localCentre(ball.getWorldTransform(), mesh.getWorldTransform(), shape);
    const Bounds bounds = shape.surface().bounds();
    const glm::vec3 at(centre);
    const glm::vec3 away = glm::max(glm::max(bounds.min - at, at - bounds.max), glm::vec3(0.0f));
    if (glm::length(away) <= static_cast<float>(reach)) {
        ahead.push_back({&mesh, centre, reach, contactsOf(shape.surface(), centre, reach)});
    }
}

MeshContacts::MeshContacts(btCollisionDispatcher& dispatcher)
    : m_sphere(std::make_unique<ContactCreation<SphereMesh>>()),
      m_hull(std::make_unique<ContactCreation<HullContacts>>()) {
    constexpr int kMesh = CUSTOM_CONCAVE_SHAPE_TYPE;
    dispatcher.registerCollisionCreateFunc(SPHERE_SHAPE_PROXYTYPE, kMesh, m_sphere.get());
    dispatcher.registerCollisionCreateFunc(kMesh, SPHERE_SHAPE_PROXYTYPE, m_sphere.get());
    for (const int other :
         {static_cast<int>(STATIC_PLANE_PROXYTYPE), static_cast<int>(BOX_SHAPE_PROXYTYPE)}) {
        dispatcher.registerCollisionCreateFunc(kMesh, other, m_hull.get());
        dispatcher.registerCollisionCreateFunc(other, kMesh, m_hull.get());
    }
    dispatcher.registerCollisionCreateFunc(kMesh, kMesh, m_hull.get());
}

MeshContacts::~MeshContacts() = default;

}  // namespace hitscope::physics
