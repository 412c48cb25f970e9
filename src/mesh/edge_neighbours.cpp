// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/edge_neighbours.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace hitscope {

EdgeNeighbours::EdgeNeighbours(const RenderMesh& render)
    : m_starts(render.fileVertexStarts.size(), 0), m_neighbours(render.edges.size()) {
    for (const std::uint32_t end : render.edges) {
        ++m_starts[render.fileVertices[end] + 1];
    }
    for (std::size_t v = 1; v < m_starts.size(); ++v) {
        m_starts[v] += m_starts[v - 1];
    }
    std::vector<std::uint32_t> next(m_starts.begin(), m_starts.end() - 1);
    for (std::size_t i = 0; i + 1 < render.edges.size(); i += 2) {
        const std::uint32_t a = render.fileVertices[render.edges[i]];
        const std::uint32_t b = render.fileVertices[render.edges[i + 1]];
        m_neighbours[next[a]++] = b;
        m_neighbours[next[b]++] = a;
    }
}

double edgeStretch(const EdgeNeighbours& neighbours, std::uint32_t fileVertex,
                   std::span<const glm::vec3> original, std::span<const glm::vec3> current) {
    const auto length = [fileVertex](std::span<const glm::vec3> positions, std::uint32_t other) {
        return glm::length(glm::dvec3(positions[other]) - glm::dvec3(positions[fileVertex]));
    };
    double most = 0.0;
    for (const std::uint32_t other : neighbours.of(fileVertex)) {
        const double before = length(original, other);
        const double stretch = before > 0.0 ? length(current, other) / before - 1.0 : 0.0;
        if (std::abs(stretch) > std::abs(most)) {
            most = stretch;
        }
    }
    return 100.0 * most;
}

}  // namespace hitscope
