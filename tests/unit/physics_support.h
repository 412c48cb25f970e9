// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

#include "physics/physics_world.h"

namespace hitscope::test {

/// A fixed sequence of numbers, the same on every machine: std's distributions are not.
class Random {
public:
    explicit Random(std::uint32_t seed) : m_engine(seed) {}
    float between(float low, float high) {
        return low + (high - low) * (static_cast<float>(m_engine() >> 8u) / 16777216.0f);
    }
    glm::vec3 direction() {
        for (;;) {
            const glm::vec3 v(between(-1, 1), between(-1, 1), between(-1, 1));
            const float length = glm::length(v);
            if (length > 0.1f && length <= 1.0f) {
                return v / length;
            }
        }
    }

private:
    std::mt19937 m_engine;
};

/// A target that must be accepted.
inline void place(PhysicsWorld& world, TargetId target, const RigidTransform& where, const Collider& collider,
                  const TargetPhysics& physics = {}) {
    if (const Status status = world.addTarget(target, where, collider, physics); !status) {
        qFatal("%s", status.error().message().c_str());
    }
}

struct Triangles {
    std::vector<glm::vec3> vertices;
    std::vector<std::uint32_t> corners;
    [[nodiscard]] std::shared_ptr<const CollisionMesh> prepared() const {
        return std::make_shared<const CollisionMesh>(
            vertices, std::make_shared<const RawVector<std::uint32_t>>(corners.begin(), corners.end()));
    }
    operator Collider() const { return MeshCollider{prepared()}; }
};

/// Advances in frames of 1/60 s and collects the impacts.
inline std::vector<Impact> run(PhysicsWorld& world, double seconds) {
    std::vector<Impact> all;
    const auto frames = static_cast<int>(std::ceil(60.0 * seconds));
    for (int frame = 0; frame < frames; ++frame) {
        const auto impacts = world.advance(1.0 / 60.0);
        all.insert(all.end(), impacts.begin(), impacts.end());
    }
    return all;
}

/// A quad of two triangles in the plane x = 0, half extent in metres.
inline Triangles sheet(float halfExtent) {
    const float h = halfExtent;
    return {{{0, -h, -h}, {0, h, -h}, {0, h, h}, {0, -h, h}}, {0, 1, 2, 0, 2, 3}};
}

/// A UV sphere as triangles.
inline Triangles sphereMesh(float radius, int segments, int rings) {
    Triangles mesh;
    for (int ring = 0; ring <= rings; ++ring) {
        const float theta = 3.14159265f * static_cast<float>(ring) / static_cast<float>(rings);
        for (int i = 0; i < segments; ++i) {
            const float phi = 6.2831853f * static_cast<float>(i) / static_cast<float>(segments);
            mesh.vertices.push_back(radius * glm::vec3(std::sin(theta) * std::cos(phi), std::cos(theta),
                                                       std::sin(theta) * std::sin(phi)));
        }
    }
    const auto at = [segments](int ring, int i) {
        return static_cast<std::uint32_t>(ring * segments + i % segments);
    };
    for (int ring = 0; ring < rings; ++ring) {
        for (int i = 0; i < segments; ++i) {
            // At the poles one of the two has no area: such triangles belong to the test.
            for (const std::uint32_t index : {at(ring, i), at(ring + 1, i), at(ring + 1, i + 1), at(ring, i),
                                              at(ring + 1, i + 1), at(ring, i + 1)}) {
                mesh.corners.push_back(index);
            }
        }
    }
    return mesh;
}

inline ProjectileSettings withSpeed(float speed) {
    ProjectileSettings settings;
    settings.speed = speed;
    return settings;
}

}  // namespace hitscope::test
