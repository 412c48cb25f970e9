// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/projectile_mesh.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/geodesic_sphere.h"

namespace hitscope::render {
namespace {

constexpr float kGrown = 0.5f;       // of the distance to the pivot
constexpr float kLeastGrown = 5.0f;  // radii from the eye

}  // namespace

BallMesh makeBall(int frequency) {
    const MeshData sphere = makeGeodesicSphere(frequency, 1.0f);
    return {{sphere.positions.begin(), sphere.positions.end()},
            {sphere.cornerVertices.begin(), sphere.cornerVertices.end()}};
}

float drawnRadius(const Camera& camera, const glm::vec3& centre, float radius) {
    if (camera.isOrthographic()) {
        return radius;
    }
    const float grown = std::max(kGrown * camera.distance(), kLeastGrown * radius);
    return radius * glm::smoothstep(0.0f, grown, glm::distance(centre, camera.eye()));
}

}  // namespace hitscope::render
