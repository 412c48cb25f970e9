// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/hit_at.h"

#include "deform/attribution.h"

namespace hitscope {

std::optional<std::size_t> hitThatMovedMost(const Session& session, const VertexRef& vertex) {
    const Target* target = session.targets().find(vertex.target);
    if (target == nullptr) {
        return std::nullopt;
    }
    const RenderMesh& mesh = target->deformed.render();
    Attribution attribution(mesh.vertices[mesh.renderVerticesOf(vertex.vertex).front()]);
    const std::span<const Hit> hits = session.hits().shown();
    for (std::size_t index = 0; index < hits.size(); ++index) {
        const Hit& hit = hits[index];
        if (hit.target == vertex.target && hit.enabled && !session.readBack().isDropped(index)) {
            attribution.add(index, hit);
        }
    }
    std::optional<std::size_t> most;
    float farthest = 0.0f;
    for (const VertexContribution& part : attribution.contributions()) {
        if (part.contribution.magnitude > 0.0f && part.contribution.magnitude >= farthest) {
            most = part.hit;
            farthest = part.contribution.magnitude;
        }
    }
    return most;
}

}  // namespace hitscope
