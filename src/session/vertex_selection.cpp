// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/vertex_selection.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "session/session.h"

namespace hitscope {

VertexSelection::VertexSelection(Session& session) : m_session(session) {
    connect(&session, &Session::sceneReplaced, this, &VertexSelection::clear);
    connect(&session.targets(), &SessionTargets::removed, this, &VertexSelection::forget);
}

std::optional<VertexRef> VertexSelection::existing(const std::optional<VertexRef>& vertex) const {
    const Target* target = vertex ? m_session.targets().find(vertex->target) : nullptr;
    return target != nullptr && vertex->vertex < target->deformed.positions().size() ? vertex : std::nullopt;
}

void VertexSelection::setHovered(const std::optional<VertexRef>& vertex) {
    if (const auto hovered = existing(vertex); hovered != m_hovered) {
        m_hovered = hovered;
        Q_EMIT hoveredChanged();
    }
}

void VertexSelection::setPicked(const std::optional<VertexRef>& vertex) {
    if (const auto picked = existing(vertex); picked != m_picked) {
        m_picked = picked;
        Q_EMIT pickedChanged();
    }
}

std::span<const std::uint32_t> VertexSelection::vertices(TargetId target) const {
    const auto found = m_selected.find(target);
    return found == m_selected.end() ? std::span<const std::uint32_t>() : found->second;
}

std::vector<TargetId> VertexSelection::targets() const {
    std::vector<TargetId> targets;
    for (const auto& entry : m_selected) {
        targets.push_back(entry.first);
    }
    return targets;
}

bool VertexSelection::isSelected(const VertexRef& vertex) const {
    const std::span<const std::uint32_t> selected = vertices(vertex.target);
    return std::binary_search(selected.begin(), selected.end(), vertex.vertex);
}

void VertexSelection::select(TargetId id, std::vector<std::uint32_t> vertices, Combine combine) {
    std::map<TargetId, std::vector<std::uint32_t>> selected;
    if (combine != Combine::Replace) {
        selected = m_selected;
    }
    const Target* target = m_session.targets().find(id);
    const std::size_t count = target != nullptr ? target->deformed.positions().size() : 0;
    std::erase_if(vertices, [count](std::uint32_t vertex) { return vertex >= count; });
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());

    const std::vector<std::uint32_t> before = std::move(selected[id]);
    std::vector<std::uint32_t>& after = selected[id];
    after.clear();
    if (combine == Combine::Remove) {
        std::set_difference(before.begin(), before.end(), vertices.begin(), vertices.end(),
                            std::back_inserter(after));
    } else {
        std::set_union(before.begin(), before.end(), vertices.begin(), vertices.end(),
                       std::back_inserter(after));
    }
    if (after.empty()) {
        selected.erase(id);
    }
    change(std::move(selected));
}

void VertexSelection::change(std::map<TargetId, std::vector<std::uint32_t>> selected) {
    if (selected == m_selected) {
        return;
    }
    m_selected = std::move(selected);
    m_count = 0;
    for (const auto& entry : m_selected) {
        m_count += entry.second.size();
    }
    ++m_revision;
    Q_EMIT selectionChanged();
}

void VertexSelection::clear() {
    setHovered(std::nullopt);
    setPicked(std::nullopt);
    change({});
}

void VertexSelection::forget(TargetId target) {
    if (m_hovered && m_hovered->target == target) {
        setHovered(std::nullopt);
    }
    if (m_picked && m_picked->target == target) {
        setPicked(std::nullopt);
    }
    auto selected = m_selected;
    selected.erase(target);
    change(std::move(selected));
}

}  // namespace hitscope
