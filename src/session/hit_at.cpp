// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/hit_at.h"

#include "deform/attribution.h"

namespace hitscope {

std::optional<std::size_t> hitThatMovedMost(const Session& session, const VertexRef& vertex) {
    const Target* target = session.target(vertex.target);
    if (target == nullptr) {
        return std::nullopt;
    }
    const auto render = target->deformed.render().renderVerticesOf(vertex.vertex);
    if (render.empty()) {
        return std::nullopt;
    }
    Attribution attribution(target->deformed.render().vertices[render.front()]);
    const std::span<const Hit> hits = session.shownHits();
    for (std::size_t index = 0; index < hits.size(); ++index) {
        const Hit& hit = hits[index];
        if (hit.target == vertex.target && hit.enabled && !session.isDropped(index)) {
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
