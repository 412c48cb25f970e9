// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/projectile_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

namespace hitscope::render {
namespace {

constexpr float kGrown = 0.5f;       // of the distance to the pivot
constexpr float kLeastGrown = 5.0f;  // radii from the eye

}  // namespace

BallMesh makeBall(int segments, int rings) {
    BallMesh ball;
    for (int ring = 0; ring <= rings; ++ring) {
        const float theta = glm::pi<float>() * static_cast<float>(ring) / static_cast<float>(rings);
        for (int segment = 0; segment <= segments; ++segment) {
            const float phi =
                glm::two_pi<float>() * static_cast<float>(segment) / static_cast<float>(segments);
            ball.vertices.emplace_back(std::sin(theta) * std::cos(phi), std::cos(theta),
                                       std::sin(theta) * std::sin(phi));
        }
    }
    const auto add = [&ball, segments](int ring, int segment) {
        ball.indices.push_back(static_cast<std::uint16_t>(ring * (segments + 1) + segment));
    };
    for (int ring = 0; ring < rings; ++ring) {
        for (int segment = 0; segment < segments; ++segment) {
            if (ring > 0) {  // at the poles one of the two triangles has no area
                add(ring, segment);
                add(ring, segment + 1);
                add(ring + 1, segment);
            }
            if (ring + 1 < rings) {
                add(ring + 1, segment);
                add(ring, segment + 1);
                add(ring + 1, segment + 1);
            }
        }
    }
    return ball;
}

float drawnRadius(const Camera& camera, const glm::vec3& centre, float radius) {
    if (camera.isOrthographic()) {
        return radius;
    }
    const float grown = std::max(kGrown * camera.distance(), kLeastGrown * radius);
    return radius * glm::smoothstep(0.0f, grown, glm::distance(centre, camera.eye()));
}

}  // namespace hitscope::render
