// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/vertex_change_order.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <iterator>
#include <utility>

namespace hitscope {

VertexChangeOrder::VertexChangeOrder(std::shared_ptr<const MeshData> original)
    : m_original(std::move(original)) {}

void VertexChangeOrder::take(std::span<const VertexState> moved) {
    if (m_placeOf.empty() && !moved.empty()) {
        m_placeOf.assign(m_original->vertexCount(), kNoIndex);
    }
    for (const VertexState& vertex : moved) {
        const std::uint32_t v = vertex.vertex;
        if (m_placeOf[v] == kNoIndex) {
            m_placeOf[v] = static_cast<std::uint32_t>(m_told.size());
            m_told.emplace_back();
            m_listed.push_back(v);
        }
        Told& told = m_told[m_placeOf[v]];
        told.current = vertex.current;
        told.length = static_cast<float>(
            glm::distance(glm::dvec3(vertex.current), glm::dvec3(m_original->positions[v])));
        told.turned = vertex.turned;
        told.hits = vertex.hits;
        if (!told.isMoved) {
            told.isMoved = true;
            m_moved.push_back(v);
        }
    }
}

VertexChangesTable VertexChangeOrder::table(std::vector<std::uint32_t> vertices) const {
    VertexChangesTable table{m_original, std::move(vertices), {}};
    table.values.reserve(table.rows.size());
    for (const std::uint32_t vertex : table.rows) {
        if (m_placeOf.empty() || m_placeOf[vertex] == kNoIndex) {
            table.values.push_back({m_original->positions[vertex], 0.0f, 0});
        } else {
            const Told& is = told(vertex);
            table.values.push_back({is.current, is.turned, is.hits});
        }
    }
    return table;
}

bool VertexChangeOrder::isShown(std::uint32_t vertex) const {
    const Told& is = told(vertex);
    return is.current != m_original->positions[vertex] && is.length >= m_query.leastLength &&
           (m_query.only == nullptr ||
            std::binary_search(m_query.only->begin(), m_query.only->end(), vertex));
}

float VertexChangeOrder::keyOf(std::uint32_t vertex, int component) const {
    switch (m_query.key) {
        case VertexQuery::Key::Original:
            return m_original->positions[vertex][component];
        case VertexQuery::Key::Current:
            return told(vertex).current[component];
        case VertexQuery::Key::Displacement:
            return told(vertex).current[component] - m_original->positions[vertex][component];
        case VertexQuery::Key::Length:
            return told(vertex).length;
        case VertexQuery::Key::Turned:
            return told(vertex).turned;
        case VertexQuery::Key::Hits:
            return static_cast<float>(told(vertex).hits);
        case VertexQuery::Key::Number:
            break;
    }
    return 0.0f;
}

bool VertexChangeOrder::isBefore(std::uint32_t a, std::uint32_t b) const {
    if (m_query.key == VertexQuery::Key::Number) {
        return m_query.descending ? b < a : a < b;
    }
    for (int component = 0; component < 3; ++component) {
        const float left = keyOf(a, component);
        const float right = keyOf(b, component);
        if (left != right) {
            return m_query.descending ? right < left : left < right;
        }
    }
    return a < b;
}

std::vector<std::uint32_t> VertexChangeOrder::rows(const VertexQuery& query) {
    if (!m_rows || query != m_query) {
        m_query = query;
        sortAll();
    } else if (!m_moved.empty()) {
        mergeMoved();
    }
    for (const std::uint32_t vertex : m_moved) {
        m_told[m_placeOf[vertex]].isMoved = false;
    }
    m_moved.clear();
    return *m_rows;
}

void VertexChangeOrder::sortAll() {
    std::vector<std::uint32_t> rows;
    std::copy_if(m_listed.begin(), m_listed.end(), std::back_inserter(rows),
                 [this](std::uint32_t vertex) { return isShown(vertex); });
    std::sort(rows.begin(), rows.end(), [this](std::uint32_t a, std::uint32_t b) { return isBefore(a, b); });
    m_rows = std::move(rows);
}

/// Those that moved leave their places and come in anew; the others are in order already.
void VertexChangeOrder::mergeMoved() {
    const auto before = [this](std::uint32_t a, std::uint32_t b) { return isBefore(a, b); };
    std::vector<std::uint32_t> moved;
    std::copy_if(m_moved.begin(), m_moved.end(), std::back_inserter(moved),
                 [this](std::uint32_t vertex) { return isShown(vertex); });
    std::sort(moved.begin(), moved.end(), before);
    std::erase_if(*m_rows, [this](std::uint32_t vertex) { return told(vertex).isMoved; });
    std::vector<std::uint32_t> merged;
    merged.reserve(m_rows->size() + moved.size());
    std::merge(m_rows->begin(), m_rows->end(), moved.begin(), moved.end(), std::back_inserter(merged),
               before);
    m_rows = std::move(merged);
}

}  // namespace hitscope
