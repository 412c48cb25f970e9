// SPDX-License-Identifier: GPL-3.0-or-later
// Targets get other meshes: of a file that has changed, or after a step.
#include <algorithm>
#include <iterator>
#include <utility>

#include "session/session.h"
#include "session/session_targets.h"

namespace hitscope {

std::map<TargetId, TargetId> SessionTargets::replaceMeshes(
    std::span<const TargetState> meshes, const std::function<std::optional<Hit>(const Hit&)>& carried,
    SessionUndo::Kind kind) {
    std::map<std::size_t, TargetState> others;  // by index
    std::map<TargetId, TargetId> ids;
    for (const TargetState& mesh : meshes) {
        if (const std::optional<std::size_t> index = indexOf(mesh.id)) {
            TargetState other = *m_targets[*index];
            other.id = ids[mesh.id] = TargetId{m_next++};
            other.shape = mesh.shape;
            other.collider = mesh.collider;
            other.source = mesh.source;
            other.steps = mesh.steps;
            other.sourcePath = mesh.sourcePath;
            other.textures = mesh.textures;
            others.emplace(*index, std::move(other));
        }
    }
    // All that come first, each behind the one that goes.
    std::vector<TargetEdit> edits;
    std::vector<TargetEdit> going;
    for (auto& [index, other] : others) {
        going.push_back({index, TargetState(*m_targets[index]), std::nullopt});
        edits.push_back({index + edits.size() + 1, std::nullopt, std::move(other)});
    }
    std::move(going.begin(), going.end(), std::back_inserter(edits));
    const std::span<const Hit> history = m_session.m_hits.history().hits();
    std::vector<std::size_t> rows;
    std::vector<std::size_t> gone;
    std::vector<Hit> hits;
    for (std::size_t row = 0; row < history.size(); ++row) {
        const auto id = ids.find(history[row].target);
        if (id == ids.end()) {
            continue;
        }
        if (const std::optional<Hit> hit = carried(history[row])) {
            rows.push_back(row);
            hits.push_back(*hit);
            hits.back().target = id->second;
        } else {
            gone.push_back(row);
        }
    }
    std::vector<HistoryEdit> hitEdits = m_session.m_hits.m_history.replace(rows, hits);
    std::ranges::move(m_session.m_hits.takeOut(gone), std::back_inserter(hitEdits));
    const auto nowOf = [&ids](TargetId id) {
        const auto found = ids.find(id);
        return found != ids.end() ? found->second : id;
    };
    const TargetId toSelect = nowOf(m_selected);
    std::vector<TargetId> beside = allSelected();
    std::transform(beside.begin(), beside.end(), beside.begin(), nowOf);
    change(std::move(edits), {kind, ids.size()}, std::move(hitEdits));
    select(toSelect, beside);
    return ids;
}

}  // namespace hitscope
