// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene_marks.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace hitscope {

namespace {

/// Any first part of them is spread over all as evenly as it can be: their numbers' bits, backwards, count
/// up.
std::vector<std::uint32_t> spread(std::vector<std::uint32_t> numbers) {
    std::sort(numbers.begin(), numbers.end());
    const auto bits = static_cast<int>(std::bit_width(numbers.size()));
    std::vector<std::uint32_t> result;
    result.reserve(numbers.size());
    for (std::size_t i = 0; i < std::size_t{1} << bits; ++i) {
        std::size_t reversed = 0;
        for (int bit = 0; bit < bits; ++bit) {
            reversed |= (i >> bit & 1U) << (bits - 1 - bit);
        }
        if (reversed < numbers.size()) {
            result.push_back(numbers[reversed]);
        }
    }
    return result;
}

}  // namespace

void SceneMarks::fill(Marks& marks, const Target* target, std::span<const std::uint32_t> fileVertices) {
    std::vector<std::uint32_t> indices;
    if (target != nullptr) {
        indices.reserve(fileVertices.size());
        for (const std::uint32_t vertex : fileVertices) {
            // All of a vertex's render vertices are at one place.
            indices.push_back(target->deformed.render().renderVerticesOf(vertex).front());
        }
    }
    // Neighbours in number are neighbours in space.
    indices = spread(std::move(indices));
    if (!marks.indices) {
        marks.indices = gl::Buffer::make();
    }
    marks.count = static_cast<GLsizei>(indices.size());
    glBindBuffer(GL_COPY_WRITE_BUFFER, marks.indices.id());
    glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)),
                 indices.data(), GL_DYNAMIC_DRAW);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
}

void SceneMarks::follow(Single& single, const Session& session, const std::optional<VertexRef>& vertex) {
    if (vertex == single.vertex) {
        return;
    }
    single.vertex = vertex;
    if (vertex) {
        fill(single.marks, session.targets().find(vertex->target), {&vertex->vertex, 1});
    }
}

void SceneMarks::follow(const Session& session) {
    const VertexSelection& selection = session.selection();
    follow(m_picked, session, selection.picked());
    follow(m_hovered, session, selection.hovered());
    if (m_revision == selection.revision()) {
        return;
    }
    m_revision = selection.revision();
    std::erase_if(m_selected, [&](const auto& entry) { return selection.vertices(entry.first).empty(); });
    for (const TargetId target : selection.targets()) {
        fill(m_selected[target], session.targets().find(target), selection.vertices(target));
    }
}

std::vector<VertexMarks> SceneMarks::on(std::span<const DrawItem> targets) const {
    std::vector<VertexMarks> marks;
    const auto add = [&marks](const DrawItem& item, const Marks& added, MarkKind kind) {
        if (added.count > 0) {
            marks.push_back({item.target, item.buffers, item.model, added.indices.id(), added.count, kind});
        }
    };
    for (const DrawItem& item : targets) {
        if (const auto found = m_selected.find(item.target); found != m_selected.end()) {
            add(item, found->second, MarkKind::Selected);
        }
    }
    for (const DrawItem& item : targets) {
        if (m_picked.vertex && m_picked.vertex->target == item.target) {
            add(item, m_picked.marks, MarkKind::Picked);
        }
        if (m_hovered.vertex && m_hovered.vertex->target == item.target) {
            add(item, m_hovered.marks, MarkKind::Hovered);
        }
    }
    return marks;
}

}  // namespace hitscope
