// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/coarse_triangles.h"

#include <meshoptimizer.h>

#include <glm/geometric.hpp>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "core/give_up.h"

namespace hitscope {
namespace {

constexpr std::size_t kFewest = 1024;  // triangles: a draw that has fewer keeps them all

/// The triangles of one draw, between vertices with numbers of their own.
class CoarsePart {
public:
    explicit CoarsePart(const RenderMesh& mesh) : m_mesh(mesh), m_placeOf(mesh.vertices.size(), kNoIndex) {}

    /// `indices`, of which about `wanted` triangles are left.
    [[nodiscard]] std::vector<std::uint32_t> simplified(std::span<const std::uint32_t> indices,
                                                        std::size_t wanted) {
        take(indices);
        std::vector<std::uint32_t> found(indices.size());
        constexpr float kAnyError = std::numeric_limits<float>::max();
        found.resize(meshopt_simplifySloppy(found.data(), m_indices.data(), m_indices.size(),
                                            &m_positions.front().x, m_positions.size(), sizeof(glm::vec3),
                                            3 * wanted, kAnyError, nullptr));
        turn(found);
        for (std::uint32_t& index : found) {
            index = m_vertices[index];
        }
        for (const std::uint32_t vertex : m_vertices) {
            m_placeOf[vertex] = kNoIndex;
        }
        return found;
    }

private:
    void take(std::span<const std::uint32_t> indices) {
        m_vertices.clear();
        m_positions.clear();
        m_indices.clear();
        m_indices.reserve(indices.size());
        for (const std::uint32_t vertex : indices) {
            mayGiveUp(m_indices.size());
            if (m_placeOf[vertex] == kNoIndex) {
                m_placeOf[vertex] = static_cast<std::uint32_t>(m_vertices.size());
                m_vertices.push_back(vertex);
                m_positions.push_back(m_mesh.vertices[vertex].position);
            }
            m_indices.push_back(m_placeOf[vertex]);
        }
        m_normals.assign(m_positions.size(), glm::vec3(0.0f));
        for (std::size_t i = 0; i + 2 < m_indices.size(); i += 3) {
            mayGiveUp(i / 3);
            const glm::vec3 normal = normalOf(&m_indices[i]);
            for (std::size_t corner = i; corner < i + 3; ++corner) {
                m_normals[m_indices[corner]] += normal;
            }
        }
    }

    /// A triangle between corners of others can face the other way than they do, and would be dark.
    void turn(std::vector<std::uint32_t>& indices) const {
        for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
            const glm::vec3 wanted =
                m_normals[indices[i]] + m_normals[indices[i + 1]] + m_normals[indices[i + 2]];
            if (glm::dot(normalOf(&indices[i]), wanted) < 0.0f) {
                std::swap(indices[i + 1], indices[i + 2]);
            }
        }
    }

    /// Of a triangle, as long as twice its area.
    [[nodiscard]] glm::vec3 normalOf(const std::uint32_t* corners) const {
        const glm::vec3& first = m_positions[corners[0]];
        return glm::cross(m_positions[corners[1]] - first, m_positions[corners[2]] - first);
    }

    const RenderMesh& m_mesh;
    std::vector<std::uint32_t> m_placeOf;   ///< of render vertices in m_vertices, or kNoIndex
    std::vector<std::uint32_t> m_vertices;  ///< render vertices
    std::vector<glm::vec3> m_positions;
    std::vector<glm::vec3> m_normals;      ///< of all triangles there, weighted by area
    std::vector<std::uint32_t> m_indices;  ///< into the three above
};

}  // namespace

void addCoarseTriangles(RenderMesh& mesh, std::size_t wanted) {
    const std::size_t all = mesh.triangles.size() / 3;
    if (all < 2 * wanted) {
        return;
    }
    CoarsePart part(mesh);
    for (const DrawRange& draw : mesh.draws) {
        const auto indices = std::span<const std::uint32_t>(mesh.triangles).subspan(draw.first, draw.count);
        const std::size_t triangles = draw.count / 3;
        const std::size_t share = wanted * triangles / all;
        const auto first = static_cast<std::uint32_t>(mesh.coarseTriangles.size());
        if (triangles < kFewest) {
            mesh.coarseTriangles.insert(mesh.coarseTriangles.end(), indices.begin(), indices.end());
        } else {
            const std::vector<std::uint32_t> found = part.simplified(indices, share);
            mesh.coarseTriangles.insert(mesh.coarseTriangles.end(), found.begin(), found.end());
        }
        const auto behind = static_cast<std::uint32_t>(mesh.coarseTriangles.size());
        mesh.coarseDraws.push_back({first, behind - first, draw.material});
    }
}

}  // namespace hitscope
