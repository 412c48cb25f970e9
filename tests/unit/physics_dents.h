// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>

#include "deform/deform.h"
#include "physics_support.h"

namespace hitscope::test {

/// A sheet in the plane x = 0 of `cells` x `cells` quads.
inline Triangles fineSheet(float halfExtent, int cells) {
    Triangles mesh;
    const auto at = [halfExtent, cells](int i) {
        return halfExtent * (2.0f * static_cast<float>(i) / static_cast<float>(cells) - 1.0f);
    };
    for (int j = 0; j <= cells; ++j) {
        for (int i = 0; i <= cells; ++i) {
            mesh.vertices.emplace_back(0.0f, at(i), at(j));
        }
    }
    const auto index = [cells](int i, int j) { return static_cast<std::uint32_t>(j * (cells + 1) + i); };
    for (int j = 0; j < cells; ++j) {
        for (int i = 0; i < cells; ++i) {
            for (const std::uint32_t corner : {index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j),
                                               index(i + 1, j + 1), index(i, j + 1)}) {
                mesh.corners.push_back(corner);
            }
        }
    }
    return mesh;
}

/// A mesh that hits deform as the pipelines would, by the function they share.
class Dented {
public:
    explicit Dented(Triangles original) : m_mesh(std::move(original)) {
        for (const glm::vec3& vertex : m_mesh.vertices) {
            m_vertices.push_back({vertex, {1, 0, 0}});
        }
    }

    void hit(const glm::vec3& point, const glm::vec3& direction) {
        Hit hit;
        hit.point = point;
        hit.direction = direction;
        for (std::size_t i = 0; i < m_vertices.size(); ++i) {
            deform(m_vertices[i].position, m_vertices[i].normal, hit);
            m_mesh.vertices[i] = m_vertices[i].position;
        }
    }

    [[nodiscard]] const Triangles& mesh() const { return m_mesh; }
    [[nodiscard]] const std::vector<DynamicVertex>& vertices() const { return m_vertices; }

    /// Metres; by looking at every triangle, with none of the collider's code.
    [[nodiscard]] float distanceFromSurface(const glm::vec3& p) const {
        float least = std::numeric_limits<float>::infinity();
        for (std::size_t i = 0; i + 2 < m_mesh.corners.size(); i += 3) {
            least = std::min(
                least, distance(p, m_mesh.vertices[m_mesh.corners[i]], m_mesh.vertices[m_mesh.corners[i + 1]],
                                m_mesh.vertices[m_mesh.corners[i + 2]]));
        }
        return least;
    }

    /// From a triangle: over its inside if that is where the foot is, else over its edges.
    [[nodiscard]] static float distance(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b,
                                        const glm::vec3& c) {
        const glm::vec3 n = glm::cross(b - a, c - a);
        const auto left = [&](const glm::vec3& from, const glm::vec3& to) {
            return glm::dot(glm::cross(to - from, p - from), n) >= 0.0f;
        };
        if (left(a, b) && left(b, c) && left(c, a) && glm::dot(n, n) > 0.0f) {
            return std::abs(glm::dot(p - a, n)) / glm::length(n);
        }
        const auto fromEdge = [&p](const glm::vec3& from, const glm::vec3& to) {
            const glm::vec3 edge = to - from;
            const float square = glm::dot(edge, edge);
            const float t = square > 0.0f ? glm::clamp(glm::dot(p - from, edge) / square, 0.0f, 1.0f) : 0.0f;
            return glm::length(p - (from + t * edge));
        };
        return std::min({fromEdge(a, b), fromEdge(b, c), fromEdge(c, a)});
    }

private:
    Triangles m_mesh;
    std::vector<DynamicVertex> m_vertices;
};

}  // namespace hitscope::test
