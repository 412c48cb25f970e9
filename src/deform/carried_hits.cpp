// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/carried_hits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <utility>

namespace hitscope {

namespace {

using FileTriangle = std::array<std::uint32_t, 3>;  // vertices of MeshData

FileTriangle triangleOf(const RenderMesh& mesh, std::size_t triangle) {
    FileTriangle vertices{};
    for (std::size_t i = 0; i < 3; ++i) {
        vertices[i] = mesh.fileVertices[mesh.triangles[3 * triangle + i]];
    }
    return vertices;
}

std::ptrdiff_t sharedVertices(const FileTriangle& a, const FileTriangle& b) {
    return std::count_if(a.begin(), a.end(), [&b](std::uint32_t vertex) {
        return std::find(b.begin(), b.end(), vertex) != b.end();
    });
}

/// Where a triangle is: its centre, its own axes, and how large it is.
struct Place {
    glm::dvec3 centre{0.0};
    glm::dmat3 axes{1.0};
    double size = 0.0;  ///< the root of twice its area; 0: it has no axes
};

Place placeOf(const MeshData& mesh, const FileTriangle& triangle) {
    const glm::dvec3 a(mesh.positions[triangle[0]]);
    const glm::dvec3 b(mesh.positions[triangle[1]]);
    const glm::dvec3 c(mesh.positions[triangle[2]]);
    Place place;
    place.centre = (a + b + c) / 3.0;
    const glm::dvec3 across = glm::cross(b - a, c - a);
    const double area = glm::length(across);
    if (area > 0.0 && std::isfinite(area)) {
        const glm::dvec3 along = glm::normalize(b - a);
        const glm::dvec3 up = across / area;
        place.axes = glm::dmat3(along, glm::cross(up, along), up);
        place.size = std::sqrt(area);
    }
    return place;
}

/// Rounding makes a small turn of none.
bool isTurn(const glm::dmat3& turn) {
    constexpr double kNone = 1.0e-6;
    const glm::dmat3 rest = turn - glm::dmat3(1.0);
    for (int column = 0; column < 3; ++column) {
        if (std::max({std::abs(rest[column].x), std::abs(rest[column].y), std::abs(rest[column].z)}) >
            kNone) {
            return true;
        }
    }
    return false;
}

glm::vec3 turned(const glm::dmat3& turn, const glm::vec3& direction) {
    return direction == glm::vec3(0.0f) ? direction : glm::vec3(glm::normalize(turn * glm::dvec3(direction)));
}

Hit moved(const Hit& hit, const Place& before, const Place& after) {
    constexpr double kSameSize = 1.0e-6;
    Hit other = hit;
    glm::dvec3 fromCentre = glm::dvec3(hit.point) - before.centre;
    if (before.size > 0.0 && after.size > 0.0) {
        const glm::dmat3 turn = after.axes * glm::transpose(before.axes);
        if (isTurn(turn)) {
            fromCentre = turn * fromCentre;
            other.direction = turned(turn, hit.direction);
            other.normal = turned(turn, hit.normal);
            other.flight = turned(turn, hit.flight);
        }
        const double scale = after.size / before.size;
        fromCentre *= std::abs(scale - 1.0) > kSameSize ? scale : 1.0;
    }
    other.point = glm::vec3(after.centre + fromCentre);
    return other;
}

}  // namespace

CarriedHits::CarriedHits(Shape before, Shape after) : m_before(std::move(before)), m_after(std::move(after)) {
    const MeshData& one = *m_before.mesh;
    const MeshData& other = *m_after.mesh;
    m_isByVertex = one.vertexCount() == other.vertexCount() && one.faceStarts == other.faceStarts &&
                   one.cornerVertices == other.cornerVertices;
    if (m_isByVertex) {
        matchTriangles();
    }
}

/// Render meshes have their triangles in the order of their places, and may cut polygons otherwise.
void CarriedHits::matchTriangles() {
    const RenderMesh& before = *m_before.render;
    const RenderMesh& after = *m_after.render;
    std::vector<std::uint32_t> starts(m_after.mesh->faceCount() + 1, 0);
    for (const std::uint32_t face : after.triangleFaces) {
        ++starts[face + 1];
    }
    for (std::size_t face = 1; face < starts.size(); ++face) {
        starts[face] += starts[face - 1];
    }
    std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
    std::vector<std::uint32_t> byFace(after.triangleFaces.size());
    for (std::uint32_t triangle = 0; triangle < byFace.size(); ++triangle) {
        byFace[next[after.triangleFaces[triangle]]++] = triangle;
    }
    m_triangles.assign(before.triangleFaces.size(), kNoIndex);
    for (std::size_t triangle = 0; triangle < m_triangles.size(); ++triangle) {
        const std::uint32_t face = before.triangleFaces[triangle];
        const FileTriangle vertices = triangleOf(before, triangle);
        std::ptrdiff_t most = 0;
        for (std::uint32_t at = starts[face]; at < starts[face + 1]; ++at) {
            const std::ptrdiff_t shared = sharedVertices(vertices, triangleOf(after, byFace[at]));
            if (shared > most) {
                most = shared;
                m_triangles[triangle] = byFace[at];
            }
        }
    }
}

Hit CarriedHits::carried(Hit hit) const {
    if (!m_isByVertex || hit.triangle >= m_triangles.size()) {
        hit.triangle = kNoIndex;
        return hit;
    }
    Hit along = alongWith(hit);
    along.triangle = hit.triangle = m_triangles[hit.triangle];
    const Result<Hit> checked = checkedHit(along);
    return checked ? checked.value() : hit;
}

Hit CarriedHits::alongWith(const Hit& hit) const {
    const FileTriangle triangle = triangleOf(*m_before.render, hit.triangle);
    const std::span<const glm::vec3> before = m_before.mesh->positions;
    const std::span<const glm::vec3> after = m_after.mesh->positions;
    const bool isSame = std::all_of(triangle.begin(), triangle.end(),
                                    [&](std::uint32_t vertex) { return before[vertex] == after[vertex]; });
    return isSame ? hit : moved(hit, placeOf(*m_before.mesh, triangle), placeOf(*m_after.mesh, triangle));
}

}  // namespace hitscope
