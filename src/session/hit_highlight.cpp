// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/hit_highlight.h"

#include "session/vertex_selection.h"

namespace hitscope {

HitHighlight::HitHighlight(Session& session, HitEffects& effects, QObject* parent)
    : QObject(parent), m_session(session), m_effects(effects) {
    connect(&session, &Session::hitSelected, this, &HitHighlight::followHit);
    connect(&effects, &HitEffects::verticesFound, this,
            [this](TargetId target, const std::vector<std::uint32_t>& vertices) {
                if (m_session.selectedHit()) {
                    light(target, vertices);
                }
            });
    connect(&session.selection(), &VertexSelection::selectionChanged, this, [this] {
        if (!m_isSelecting) {
            m_isLit = false;
        }
    });
}

void HitHighlight::followHit() {
    if (const std::optional<std::size_t> hit = m_session.selectedHit()) {
        m_effects.findVertices(*hit);
    } else if (m_isLit) {
        light(m_session.selectedTarget(), {});
    }
}

void HitHighlight::light(TargetId target, const std::vector<std::uint32_t>& vertices) {
    m_isSelecting = true;
    m_session.selection().select(target, vertices, VertexSelection::Combine::Replace);
    m_isSelecting = false;
    m_isLit = !vertices.empty();
}

}  // namespace hitscope
