// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/reference_scene.h"

#include <optional>
#include <utility>
#include <vector>

namespace hitscope {

ReferenceScene::ReferenceScene(Session& session) : m_session(session), m_readBack(session.readBack({})) {}

void ReferenceScene::begin(TargetId target, std::shared_ptr<const RenderMesh> mesh) {
    m_targets.erase(target);
    Followed& followed = m_targets.try_emplace(target, std::move(mesh)).first->second;
    followed.deformation.edit({.target = target,
                               .first = 0,
                               .before = {},
                               .after = {m_hits.of(target).begin(), m_hits.of(target).end()}});
}

void ReferenceScene::followTargets() {
    std::erase_if(m_targets,
                  [this](const auto& entry) { return m_session.targets().find(entry.first) == nullptr; });
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        const auto known = m_targets.find(target->id);
        if (known == m_targets.end() || known->second.mesh != target->deformed.sharedRender()) {
            begin(target->id, target->deformed.sharedRender());
        }
    }
}

void ReferenceScene::startOver() {
    const std::span<const Hit> shown = m_session.hits().shown();
    m_hits.reset(shown);
    m_applied.reset(shown.size());
    m_readBack.restart();
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        begin(target->id, target->deformed.sharedRender());
    }
}

void ReferenceScene::followHistory() {
    const HitHistory& history = m_session.hits().history();
    const std::optional<std::vector<HistoryEdit>> edits = history.editsSince(m_seenRevision);
    m_seenRevision = history.revision();
    if (!std::exchange(m_hasStarted, true) || !edits) {
        startOver();
        return;
    }
    for (const HistoryEdit& edit :
         m_applied.follow(*edits, history.hits(), m_session.hits().shown().size())) {
        for (const TargetHitsEdit& change : m_hits.apply(edit)) {
            if (const auto target = m_targets.find(change.target); target != m_targets.end()) {
                target->second.deformation.edit(change);
            }
        }
    }
}

void ReferenceScene::sync() {
    followTargets();
    followHistory();
    m_readBack.setCapacity({});
    for (auto& [id, target] : m_targets) {
        target.deformation.advance();
        for (const VertexRange& range : target.deformation.takeChanged()) {
            m_readBack.take(id, range.first, target.deformation.vertices(range));
        }
    }
    m_readBack.finish();
    m_readBack.setUpToDate();
}

}  // namespace hitscope
