// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMetaType>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

#include "deform/deform.h"
#include "mesh/render_mesh.h"

Q_DECLARE_METATYPE(glm::vec3)

namespace hitscope::test {

inline glm::vec3 randomPoint(std::mt19937& random, float extent) {
    std::uniform_real_distribution<float> coordinate(-extent, extent);
    const float x = coordinate(random);
    const float y = coordinate(random);
    return {x, y, coordinate(random)};
}

/// The paper's constants, somewhere in the box of half size `extent`.
inline Hit randomHit(std::mt19937& random, float extent) {
    Hit hit;
    hit.point = randomPoint(random, extent);
    hit.direction = glm::normalize(randomPoint(random, 1.0f) + glm::vec3(0.0f, 0.0f, 1e-3f));
    return hit;
}

/// Every hit on every vertex: the plain loop that all shortcuts are held against.
struct BruteForce {
    explicit BruteForce(const RenderMesh& mesh) : vertices(mesh.vertices.begin(), mesh.vertices.end()) {}

    /// The vertices that the hit reached.
    std::vector<std::uint32_t> apply(const Hit& hit) {
        std::vector<std::uint32_t> reached;
        for (std::uint32_t i = 0; i < vertices.size(); ++i) {
            if (deform(vertices[i].position, vertices[i].normal, hit)) {
                reached.push_back(i);
            }
        }
        return reached;
    }

    std::vector<DynamicVertex> vertices;
};

}  // namespace hitscope::test
