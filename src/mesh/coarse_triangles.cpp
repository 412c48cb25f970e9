// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/coarse_triangles.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <bit>
#include <glm/geometric.hpp>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "core/give_up.h"

namespace hitscope {
namespace {

constexpr std::size_t kFewest = 1024;  // triangles: a draw that has fewer keeps them all
// Of a mesh with far more triangles than are wanted, vertices beside each other are taken for one first, so
// that the simplifier works on about so many triangles for each that is wanted. (10,000,000 triangles: 0.2 s
// instead of 2 s.)
constexpr std::size_t kEnough = 16;
constexpr std::size_t kMostTogether = 16;  // vertices
constexpr float kSliver = 0.3f;            // height, times the longest edge
constexpr float kNear = 1.0f / 512.0f;     // of the mesh's diagonal; others stay apart

/// The triangles of one draw, between vertices with numbers of their own.
class CoarsePart {
public:
    explicit CoarsePart(const RenderMesh& mesh)
        : m_mesh(mesh),
          m_near(kNear * glm::distance(mesh.bounds.min, mesh.bounds.max)),
          m_placeOf(mesh.vertices.size(), kNoIndex),
          m_placeOfGroup(mesh.vertices.size() / 2 + 1, kNoIndex) {}

    /// `indices`, of which about `wanted` triangles are left.
    [[nodiscard]] std::vector<std::uint32_t> simplified(std::span<const std::uint32_t> indices,
                                                        std::size_t wanted) {
        const std::size_t enough = 3 * kEnough * std::max<std::size_t>(wanted, 1);
        m_together = std::bit_floor(std::clamp<std::size_t>(indices.size() / enough, 1, kMostTogether));
        take(indices);
        if (m_together > 1 && m_indices.size() < enough / 4) {  // most triangles were between such neighbours
            forget(indices);
            m_together = 1;
            take(indices);
        }
        std::vector<std::uint32_t> found(m_indices.size());
        constexpr float kAnyError = std::numeric_limits<float>::max();
        found.resize(meshopt_simplifySloppy(found.data(), m_indices.data(), m_indices.size(),
                                            &m_positions.front().x, m_positions.size(), sizeof(glm::vec3),
                                            3 * wanted, kAnyError, nullptr));
        turn(found);
        for (std::uint32_t& index : found) {
            index = m_vertices[index];
        }
        forget(indices);
        return found;
    }

private:
    void forget(std::span<const std::uint32_t> indices) {
        for (const std::uint32_t vertex : indices) {
            m_placeOf[vertex] = kNoIndex;
        }
        if (m_together > 1) {
            m_placeOfGroup.assign(m_placeOfGroup.size(), kNoIndex);
        }
    }

    void take(std::span<const std::uint32_t> indices) {
        m_vertices.clear();
        m_positions.clear();
        m_indices.clear();
        m_indices.reserve(indices.size() / m_together);
        for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
            mayGiveUp(i / 3);
            const std::uint32_t a = placeOf(indices[i]);
            const std::uint32_t b = placeOf(indices[i + 1]);
            const std::uint32_t c = placeOf(indices[i + 2]);
            if (m_together == 1 || (a != b && b != c && c != a)) {
                m_indices.insert(m_indices.end(), {a, b, c});
            }
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

    [[nodiscard]] std::size_t groupOf(std::uint32_t vertex) const { return vertex / m_together; }

    std::uint32_t placeOf(std::uint32_t vertex) {
        std::uint32_t& place = m_placeOf[vertex];
        if (place != kNoIndex) {
            return place;
        }
        if (m_together == 1) {
            return place = addPlace(vertex);
        }
        // Neighbours in the buffer are neighbours in space, but for the few where the order jumps.
        std::uint32_t& first = m_placeOfGroup[groupOf(vertex)];
        if (first == kNoIndex) {
            return place = first = addPlace(vertex);
        }
        const bool isNear = glm::distance(m_positions[first], m_mesh.vertices[vertex].position) <= m_near;
        return place = isNear ? first : addPlace(vertex);
    }
    std::uint32_t addPlace(std::uint32_t vertex) {
        m_vertices.push_back(vertex);
        m_positions.push_back(m_mesh.vertices[vertex].position);
        return static_cast<std::uint32_t>(m_vertices.size() - 1);
    }

    /// A triangle between corners of others can face the other way than they do, and would be dark. Slivers
    /// among these are folds under their neighbours, and go: turned, pixels of them would be dark from the
    /// side.
    void turn(std::vector<std::uint32_t>& indices) const {
        std::size_t kept = 0;
        for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
            const std::array<std::uint32_t, 3> corners{indices[i], indices[i + 1], indices[i + 2]};
            const glm::vec3 wanted = m_normals[corners[0]] + m_normals[corners[1]] + m_normals[corners[2]];
            const glm::vec3 normal = normalOf(corners.data());
            const bool isTurned = glm::dot(normal, wanted) < 0.0f;
            if (isTurned && glm::length(normal) < kSliver * longestSquared(corners)) {
                continue;
            }
            indices[kept++] = corners[0];
            indices[kept++] = isTurned ? corners[2] : corners[1];
            indices[kept++] = isTurned ? corners[1] : corners[2];
        }
        indices.resize(kept);
    }

    [[nodiscard]] float longestSquared(const std::array<std::uint32_t, 3>& corners) const {
        const auto squared = [&](std::size_t from, std::size_t to) {
            const glm::vec3 way = m_positions[corners[to]] - m_positions[corners[from]];
            return glm::dot(way, way);
        };
        return std::max({squared(0, 1), squared(1, 2), squared(2, 0)});
    }

    /// Of a triangle, as long as twice its area.
    [[nodiscard]] glm::vec3 normalOf(const std::uint32_t* corners) const {
        const glm::vec3& first = m_positions[corners[0]];
        return glm::cross(m_positions[corners[1]] - first, m_positions[corners[2]] - first);
    }

    const RenderMesh& m_mesh;
    float m_near;                               ///< metres
    std::size_t m_together = 1;                 ///< vertices that are taken for one, a power of two
    std::vector<std::uint32_t> m_placeOf;       ///< of render vertices in m_vertices, or kNoIndex
    std::vector<std::uint32_t> m_placeOfGroup;  ///< of the first of such neighbours that is met
    std::vector<std::uint32_t> m_vertices;      ///< render vertices
    std::vector<glm::vec3> m_positions;
    std::vector<glm::vec3> m_normals;      ///< of all triangles there, weighted by area
    std::vector<std::uint32_t> m_indices;  ///< into the three above
};

std::vector<std::uint32_t> byLowestCorner(const std::vector<std::uint32_t>& indices) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    triangles.reserve(indices.size() / 3);
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        triangles.push_back({indices[i], indices[i + 1], indices[i + 2]});
    }
    std::stable_sort(triangles.begin(), triangles.end(),
                     [](const auto& a, const auto& b) { return std::ranges::min(a) < std::ranges::min(b); });
    std::vector<std::uint32_t> sorted;
    sorted.reserve(indices.size());
    for (const auto& triangle : triangles) {
        sorted.insert(sorted.end(), triangle.begin(), triangle.end());
    }
    return sorted;
}

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
            const std::vector<std::uint32_t> found = byLowestCorner(part.simplified(indices, share));
            mesh.coarseTriangles.insert(mesh.coarseTriangles.end(), found.begin(), found.end());
        }
        const auto behind = static_cast<std::uint32_t>(mesh.coarseTriangles.size());
        mesh.coarseDraws.push_back({first, behind - first, draw.material});
    }
    mesh.coarseRuns =
        ClusterRuns(mesh.vertices, mesh.coarseTriangles, 3, mesh.coarseDraws, mesh.triangles.size());
}

}  // namespace hitscope
