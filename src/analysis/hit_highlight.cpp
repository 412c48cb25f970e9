// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/hit_highlight.h"

#include "session/vertex_selection.h"

namespace hitscope {

HitHighlight::HitHighlight(Session& session, HitEffects& effects, QObject* parent)
    : QObject(parent), m_session(session), m_effects(effects) {
    connect(&session.hits(), &SessionHits::selectedChanged, this, &HitHighlight::followHit);
    // The effects have been connected before: what is asked about is the history as it is now.
    connect(&session.hits(), &SessionHits::changed, this, &HitHighlight::followHistory);
    connect(&session.hits(), &SessionHits::rearranged, this, &HitHighlight::followHistory);
    connect(&effects, &HitEffects::verticesFound, this,
            [this](TargetId target, const std::vector<std::uint32_t>& vertices) {
                if (m_follows && m_session.hits().selected()) {
                    light(target, vertices);
                }
            });
    connect(&session.selection(), &VertexSelection::selectionChanged, this, [this] {
        if (!m_isSelecting) {
            m_isLit = false;
            m_follows = false;
        }
    });
}

void HitHighlight::followHit() {
    const std::optional<std::size_t> hit = m_session.hits().selected();
    m_follows = hit.has_value();
    if (hit) {
        m_effects.findVertices(*hit);
    } else if (m_isLit) {
        light(m_session.targets().selected(), {});
    }
}

void HitHighlight::followHistory() {
    const std::optional<std::size_t> hit = m_session.hits().selected();
    if (hit && m_follows) {
        m_effects.findVertices(*hit);
    }
}

void HitHighlight::light(TargetId target, const std::vector<std::uint32_t>& vertices) {
    m_isSelecting = true;
    m_session.selection().select(target, vertices, VertexSelection::Combine::Replace);
    m_isSelecting = false;
    m_isLit = !vertices.empty();
}

}  // namespace hitscope
