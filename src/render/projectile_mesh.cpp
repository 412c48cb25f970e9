// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/projectile_mesh.h"

#include <cmath>
#include <glm/gtc/constants.hpp>

namespace hitscope::render {

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

}  // namespace hitscope::render
