// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

#include "deform/reference.h"
#include "session/session.h"
#include "support/read_back.h"

namespace hitscope::test {

/// Hands the session what a pipeline makes of its hits, as SceneGpu does, without a GPU.
inline void readBack(Session& session) {
    for (const std::unique_ptr<Target>& target : session.targets()) {
        std::vector<Hit> hits;
        for (std::size_t i = 0; i < session.hits().history().size(); ++i) {
            const Hit& hit = session.hits().history().hits()[i];
            if (hit.target == target->id && session.hits().isApplied(i)) {
                hits.push_back(hit);
            }
        }
        ReferenceDeformation reference(target->deformed.render());
        reference.apply(hits);
        test::readBackOf(session).take(target->id, 0, reference.vertices());
    }
    test::readBackOf(session).finish();
}

/// Hits on a target's original vertices, from about the direction of its normal.
inline std::vector<Hit> randomHits(const Target& target, std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> offset(-0.4f, 0.4f);
    const std::span<const DynamicVertex> vertices = target.deformed.render().vertices;
    std::vector<Hit> hits;
    for (std::size_t i = 0; i < count; ++i) {
        const DynamicVertex& vertex = vertices[random() % vertices.size()];
        Hit hit;
        hit.target = target.id;
        hit.point = vertex.position + 0.1f * glm::vec3(offset(random), offset(random), offset(random));
        hit.direction =
            glm::normalize(-vertex.normal + glm::vec3(offset(random), offset(random), offset(random)));
        hits.push_back(hit);
    }
    return hits;
}

}  // namespace hitscope::test
