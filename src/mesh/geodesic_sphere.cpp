// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/geodesic_sphere.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <unordered_map>
#include <utility>

namespace hitscope {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

constexpr std::array<Triangle, 20> kFaces{{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                           {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                           {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                           {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}}};

std::array<glm::dvec3, 12> icosahedron() {
    const double g = std::numbers::phi;
    return {{{-1, g, 0},
             {1, g, 0},
             {-1, -g, 0},
             {1, -g, 0},
             {0, -1, g},
             {0, 1, g},
             {0, -1, -g},
             {0, 1, -g},
             {g, 0, -1},
             {g, 0, 1},
             {-g, 0, -1},
             {-g, 0, 1}}};
}

class Builder {
public:
    Builder(int frequency, float radius)
        : m_frequency(static_cast<std::uint32_t>(std::max(frequency, 1))), m_radius(radius) {
        m_mesh.name = "Geodesic sphere";
        m_mesh.faceStarts.push_back(0);
        for (const glm::dvec3& corner : m_corners) {
            addVertex(corner);
        }
        for (const Triangle& face : kFaces) {
            cut(face);
        }
        addTexcoords();
        m_mesh.cornerNormals = m_mesh.cornerVertices;
    }

    [[nodiscard]] MeshData take() { return std::move(m_mesh); }

private:
    std::uint32_t addVertex(const glm::dvec3& direction) {
        const glm::dvec3 unit = glm::normalize(direction);
        m_mesh.normals.emplace_back(unit);
        m_mesh.positions.emplace_back(unit * static_cast<double>(m_radius));
        return static_cast<std::uint32_t>(m_mesh.positions.size() - 1);
    }

    /// The point of a face with these shares of its corners, which sum to the frequency. Points on an edge
    /// belong to both faces beside it, so they are named by the two corners that have a share.
    std::uint32_t pointOf(const Triangle& face, const Triangle& shares) {
        std::array<std::pair<std::uint32_t, std::uint32_t>, 3> named{};  // corner, share
        std::size_t count = 0;
        glm::dvec3 sum(0.0);
        for (std::size_t i = 0; i < 3; ++i) {
            sum += static_cast<double>(shares[i]) * m_corners[face[i]];
            if (shares[i] > 0) {
                named[count++] = {face[i], shares[i]};
            }
        }
        if (count == 1) {
            return named[0].first;
        }
        if (count == 3) {
            return addVertex(sum);
        }
        std::sort(named.begin(), named.begin() + 2);
        const std::array<std::uint32_t, 3> name{named[0].first, named[1].first, named[0].second};
        const auto known = m_onEdges.find(name);
        return known != m_onEdges.end() ? known->second
                                        : m_onEdges.emplace(name, addVertex(sum)).first->second;
    }

    void cut(const Triangle& face) {
        const std::uint32_t n = m_frequency;
        std::vector<std::uint32_t> above;
        for (std::uint32_t row = 0; row <= n; ++row) {
            std::vector<std::uint32_t> line;
            for (std::uint32_t i = 0; i <= row; ++i) {
                line.push_back(pointOf(face, {n - row, row - i, i}));
            }
            for (std::uint32_t i = 0; i < row; ++i) {
                addFace({above[i], line[i], line[i + 1]});
                if (i + 1 < row) {
                    addFace({above[i], line[i + 1], above[i + 1]});
                }
            }
            above = std::move(line);
        }
    }

    void addFace(const Triangle& corners) {
        m_mesh.cornerVertices.insert(m_mesh.cornerVertices.end(), corners.begin(), corners.end());
        m_mesh.faceStarts.push_back(static_cast<std::uint32_t>(m_mesh.cornerVertices.size()));
    }

    [[nodiscard]] glm::vec2 globe(std::uint32_t vertex) const {
        const glm::vec3& n = m_mesh.normals[vertex];
        const float u = 0.5f + std::atan2(n.x, n.z) / (2.0f * std::numbers::pi_v<float>);
        return {u, 0.5f + std::asin(std::clamp(n.y, -1.0f, 1.0f)) / std::numbers::pi_v<float>};
    }

    [[nodiscard]] bool isPole(std::uint32_t vertex) const {
        const glm::vec3& n = m_mesh.normals[vertex];
        return n.x * n.x + n.z * n.z < 1.0e-10f;
    }

    /// One entry a vertex, and more where a face lies over the seam or touches a pole.
    void addTexcoords() {
        for (std::uint32_t v = 0; v < m_mesh.positions.size(); ++v) {
            m_mesh.texcoords.push_back(globe(v));
        }
        m_mesh.cornerTexcoords = m_mesh.cornerVertices;
        std::unordered_map<std::uint32_t, std::uint32_t> beyondSeam;
        for (std::size_t first = 0; first < m_mesh.cornerVertices.size(); first += 3) {
            stitch(first, beyondSeam);
        }
    }

    void stitch(std::size_t first, std::unordered_map<std::uint32_t, std::uint32_t>& beyondSeam) {
        const std::span corners = std::span(m_mesh.cornerTexcoords).subspan(first, 3);
        float largest = 0.0f;
        for (const std::uint32_t corner : corners) {
            largest = std::max(largest, isPole(corner) ? 0.0f : m_mesh.texcoords[corner].x);
        }
        float sum = 0.0f;
        std::size_t pole = 3;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t vertex = corners[i];
            if (isPole(vertex)) {
                pole = i;
                continue;
            }
            if (largest - m_mesh.texcoords[vertex].x > 0.5f) {
                const auto [entry, isNew] =
                    beyondSeam.try_emplace(vertex, static_cast<std::uint32_t>(m_mesh.texcoords.size()));
                if (isNew) {
                    m_mesh.texcoords.push_back(m_mesh.texcoords[vertex] + glm::vec2(1.0f, 0.0f));
                }
                corners[i] = entry->second;
            }
            sum += m_mesh.texcoords[corners[i]].x;
        }
        if (pole < 3) {
            m_mesh.texcoords.emplace_back(0.5f * sum, m_mesh.texcoords[corners[pole]].y);
            corners[pole] = static_cast<std::uint32_t>(m_mesh.texcoords.size() - 1);
        }
    }

    std::uint32_t m_frequency;
    float m_radius;
    std::array<glm::dvec3, 12> m_corners = icosahedron();
    std::map<std::array<std::uint32_t, 3>, std::uint32_t> m_onEdges;
    MeshData m_mesh;
};

}  // namespace

MeshData makeGeodesicSphere(int frequency, float radius) {
    return Builder(frequency, radius).take();
}

}  // namespace hitscope
