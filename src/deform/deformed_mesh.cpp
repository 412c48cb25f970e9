// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/deformed_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "mesh/same_bits.h"

namespace hitscope {

DeformedMesh::DeformedMesh(std::shared_ptr<const MeshData> original, std::shared_ptr<const RenderMesh> render)
    : m_original(std::move(original)), m_render(std::move(render)) {}

void DeformedMesh::makeOwn() {
    if (m_isOriginal) {
        m_vertices = PageCopy(m_render->vertices);
        m_positions = PageCopy(m_original->positions);
        m_listed.assign(m_positions.size(), false);
        m_isOriginal = false;
    }
}

void DeformedMesh::write(std::uint32_t first, std::span<const DynamicVertex> vertices,
                         std::vector<std::uint32_t>& moved) {
    makeOwn();
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const glm::vec3& position = vertices[i].position;
        if (sameBits(position, m_vertices[first + i].position)) {
            continue;
        }
        const std::uint32_t fileVertex = m_render->fileVertices[first + i];
        moved.push_back(fileVertex);
        m_positions[fileVertex] = position;
        if (!m_listed[fileVertex]) {
            m_listed[fileVertex] = true;
            m_changed.push_back(fileVertex);
        }
    }
    std::copy(vertices.begin(), vertices.end(), m_vertices.data() + first);
    ++m_revision;
}

void DeformedMesh::reset() {
    if (!m_isOriginal) {
        m_vertices = PageCopy(m_render->vertices);
    }
    for (const std::uint32_t fileVertex : m_changed) {
        m_positions[fileVertex] = m_original->positions[fileVertex];
        m_listed[fileVertex] = false;
    }
    m_changed.clear();
    ++m_revision;
}

bool DeformedMesh::isChanged(std::uint32_t fileVertex) const {
    return positions()[fileVertex] != m_original->positions[fileVertex];
}

glm::vec3 DeformedMesh::displacement(std::uint32_t fileVertex) const {
    return positions()[fileVertex] - m_original->positions[fileVertex];
}

DisplacementStatistics DeformedMesh::statistics() const {
    DisplacementStatistics statistics;
    double sum = 0.0;
    double sumOfSquares = 0.0;
    for (const std::uint32_t fileVertex : m_changed) {
        if (!isChanged(fileVertex)) {
            continue;  // a later hit brought it back
        }
        const glm::dvec3 moved =
            glm::dvec3(m_positions[fileVertex]) - glm::dvec3(m_original->positions[fileVertex]);
        const double squared = glm::dot(moved, moved);
        const double length = std::sqrt(squared);
        ++statistics.changedVertices;
        statistics.maximum = std::max(statistics.maximum, length);
        sum += length;
        sumOfSquares += squared;
    }
    if (statistics.changedVertices > 0) {
        const double count = static_cast<double>(statistics.changedVertices);
        statistics.mean = sum / count;
        statistics.rms = std::sqrt(sumOfSquares / count);
    }
    return statistics;
}

}  // namespace hitscope
