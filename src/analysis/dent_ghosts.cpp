// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/dent_ghosts.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <optional>

#include "deform/cluster_reach.h"
#include "deform/deform.h"

namespace hitscope {

namespace {

/// The mesh with the hits, as far as they are not too much.
class GhostSurface {
public:
    GhostSurface(const RenderMesh& mesh, std::span<const glm::vec3> positions)
        : m_mesh(mesh),
          m_vertices(mesh.vertices.begin(), mesh.vertices.end()),
          m_isMoved(mesh.vertices.size()),
          m_reach(mesh) {
        for (std::size_t i = 0; i < m_vertices.size(); ++i) {
            m_vertices[i].position = positions[mesh.fileVertices[i]];
        }
        m_reach.place(0, m_vertices);
    }

    /// Returns whether there is room for more.
    bool apply(const Hit& hit) {
        m_clusters.clear();
        m_reach.advance(hit, m_clusters);
        for (const std::uint32_t number : m_clusters) {
            const Cluster& cluster = m_mesh.clusters[number];
            for (std::uint32_t i = cluster.first; i < cluster.first + cluster.count; ++i) {
                DynamicVertex& vertex = m_vertices[i];
                if (deform(vertex.position, vertex.normal, hit)) {
                    m_isMoved[i] = true;
                }
            }
            m_reach.place(cluster.first, std::span(m_vertices).subspan(cluster.first, cluster.count));
            m_moves += cluster.count;
        }
        return m_moves <= kMostGhostMoves;
    }

    /// Nothing: there are too many.
    [[nodiscard]] std::optional<std::vector<glm::vec3>> dents() const {
        std::vector<glm::vec3> dents;
        for (std::size_t first = 0; first + 2 < m_mesh.triangles.size(); first += 3) {
            const std::uint32_t* corners = &m_mesh.triangles[first];
            if (!m_isMoved[corners[0]] && !m_isMoved[corners[1]] && !m_isMoved[corners[2]]) {
                continue;
            }
            if (dents.size() == 3 * kMostGhostTriangles) {
                return std::nullopt;
            }
            for (int i = 0; i < 3; ++i) {
                dents.push_back(m_vertices[corners[i]].position);
            }
        }
        return dents;
    }

private:
    const RenderMesh& m_mesh;
    std::vector<DynamicVertex> m_vertices;
    std::vector<bool> m_isMoved;
    ClusterReach m_reach;
    std::vector<std::uint32_t> m_clusters;
    std::size_t m_moves = 0;
};

/// Half the way between so many marks that are spread over the mesh.
float halfSpacing(const RenderMesh& mesh, std::size_t hits) {
    const glm::vec3 size = mesh.bounds.max - mesh.bounds.min;
    const float area = 2.0f * (size.x * size.y + size.y * size.z + size.z * size.x);
    return 0.5f * std::sqrt(area / static_cast<float>(std::max<std::size_t>(hits, 1)));
}

}  // namespace

DentGhosts dentGhosts(const RenderMesh& mesh, std::span<const glm::vec3> positions, std::span<const Hit> hits,
                      const std::function<bool()>& isStopped) {
    GhostSurface surface(mesh, positions);
    bool isRoom = true;
    for (const Hit& hit : hits) {
        if (!isRoom || (isStopped && isStopped())) {
            break;
        }
        isRoom = !hit.enabled || surface.apply(hit);
    }
    std::optional<std::vector<glm::vec3>> dents = isRoom ? surface.dents() : std::nullopt;
    return dents ? DentGhosts{std::move(*dents), true}
                 : DentGhosts{markGhosts(hits, halfSpacing(mesh, hits.size())), false};
}

std::vector<glm::vec3> markGhosts(std::span<const Hit> hits, float widest) {
    constexpr std::size_t kFewest = 3;
    constexpr std::size_t kMost = 16;
    const std::size_t sides =
        std::clamp(kMostGhostTriangles / std::max<std::size_t>(hits.size(), 1), kFewest, kMost);
    const std::size_t shown = std::min(hits.size(), kMostGhostTriangles / sides);
    std::vector<glm::vec3> triangles;
    triangles.reserve(3 * sides * shown);
    for (std::size_t i = 0; i < shown; ++i) {
        const Hit& hit = hits[i * hits.size() / shown];
        const float radius = std::min(hit.constants.maxDistance, widest);
        const glm::vec3 axis = hit.normal == glm::vec3(0.0f) ? -hit.direction : hit.normal;
        const glm::vec3 other =
            std::abs(axis.y) > 0.9f ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
        const glm::vec3 right = radius * glm::normalize(glm::cross(other, axis));
        const glm::vec3 up = glm::cross(axis, right);
        const glm::vec3 tip = hit.point + 0.5f * radius * hit.direction;
        const auto rim = [&](std::size_t corner) {
            const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(corner % sides) /
                                static_cast<float>(sides);
            return hit.point + std::cos(angle) * right + std::sin(angle) * up;
        };
        for (std::size_t side = 0; side < sides; ++side) {
            triangles.insert(triangles.end(), {rim(side), rim(side + 1), tip});
        }
    }
    return triangles;
}

}  // namespace hitscope
