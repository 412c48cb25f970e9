// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/corner_normals.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/give_up.h"
#include "core/parallel.h"
#include "mesh/triangulate.h"

namespace hitscope {
namespace {

/// Every corner of a vertex is compared with every other; the hub of a larger fan has all its faces averaged
/// once, so that the work stays in proportion to the mesh.
constexpr std::size_t kMostFacesCompared = 256;

// Fewer are done sooner than a thread is started.
constexpr std::size_t kNormalsAThread = 16384;
constexpr std::size_t kVerticesAThread = 8192;
constexpr std::size_t kFacesAThread = 16384;

/// The zero vector when v has no usable direction.
glm::dvec3 unitOrZero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return std::isfinite(length) && length > 0.0 ? v / length : glm::dvec3(0.0);
}

/// 3 or 4 if all faces have so many corners; else 0.
std::uint32_t sizeOfAll(const MeshData& mesh) {
    const std::size_t faces = mesh.faceCount();
    const std::uint32_t size = faces > 0 ? mesh.faceStarts[1] : 0;
    if (size != 3 && size != 4) {
        return 0;
    }
    std::size_t face = 0;
    while (face < faces && mesh.faceStarts[face + 1] - mesh.faceStarts[face] == size) {
        ++face;
    }
    return face == faces ? size : 0;
}

}  // namespace

VertexCorners::VertexCorners(const MeshData& mesh)
    : m_corners(sortedByKey(mesh.cornerVertices.size(), mesh.vertexCount(),
                            [&mesh](std::size_t corner) { return mesh.cornerVertices[corner]; })) {}

CornerFaces::CornerFaces(const MeshData& mesh)
    : m_size(sizeOfAll(mesh)), m_faces(m_size == 0 ? mesh.cornerVertices.size() : 0) {
    if (m_faces.empty()) {
        return;
    }
    inWatchedParts(mesh.faceCount(), kFacesAThread, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
            std::fill(m_faces.begin() + mesh.faceStarts[f], m_faces.begin() + mesh.faceStarts[f + 1],
                      static_cast<std::uint32_t>(f));
        }
    });
}

CornerNormals::CornerNormals(const MeshData& mesh, const VertexCorners& vertexCorners,
                             const CornerFaces& cornerFaces, float creaseAngle)
    : m_mesh(mesh),
      m_vertexCorners(vertexCorners),
      m_cornerFaces(cornerFaces),
      m_cosine(std::cos(static_cast<double>(creaseAngle))),
      m_units(mesh.normals.size()) {
    inWatchedParts(mesh.normals.size(), kNormalsAThread, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            m_units[i] = glm::vec3(unitOrZero(glm::dvec3(mesh.normals[i])));
        }
    });
    const auto isUsable = [this](std::uint32_t n) { return n != kNoIndex && m_units[n] != glm::vec3(0.0f); };
    if (mesh.cornerNormals.size() != mesh.cornerVertices.size() ||
        !std::all_of(mesh.cornerNormals.begin(), mesh.cornerNormals.end(), isUsable)) {
        measureFaces();
    }
}

void CornerNormals::measureFaces() {
    m_areas.resize(m_mesh.faceCount());
    inWatchedParts(m_mesh.faceCount(), kFacesAThread, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
            m_areas[f] = doubleAreaVector(m_mesh.positions, m_mesh.face(f));
        }
    });
}

std::span<const glm::vec3> CornerNormals::Reader::of(std::size_t vertex) {
    const std::span<const std::uint32_t> around = m_all.m_vertexCorners.of(vertex);
    const std::vector<std::uint32_t>& given = m_all.m_mesh.cornerNormals;
    m_normals.clear();
    bool isComplete = true;
    for (const std::uint32_t corner : around) {
        const std::uint32_t normal = corner < given.size() ? given[corner] : kNoIndex;
        m_normals.push_back(normal != kNoIndex ? m_all.m_units[normal] : glm::vec3(0.0f));
        isComplete = isComplete && m_normals.back() != glm::vec3(0.0f);
    }
    if (!isComplete) {
        computeMissing(around);
    }
    return m_normals;
}

/// Fills the zero vectors among the normals.
void CornerNormals::Reader::computeMissing(std::span<const std::uint32_t> around) {
    m_faces.clear();
    for (const std::uint32_t corner : around) {
        const std::uint32_t face = m_all.m_cornerFaces[corner];
        const glm::dvec3& area = m_all.m_areas[face];
        m_faces.push_back({face, area, glm::vec3(unitOrZero(area))});
    }
    const glm::vec3 average = averageNormal();
    const bool areOne = m_faces.size() > kMostFacesCompared || areAllJoined();
    for (std::size_t i = 0; i < m_faces.size(); ++i) {
        if (m_normals[i] == glm::vec3(0.0f)) {
            const bool isAveraged = areOne || m_faces[i].unit == glm::vec3(0.0f);
            m_normals[i] = isAveraged ? average : smoothNormal(m_faces[i]);
        }
    }
}

glm::vec3 CornerNormals::Reader::averageNormal() const {
    glm::dvec3 sum(0.0);
    for (const Face& face : m_faces) {
        sum += face.area;
    }
    const glm::dvec3 normal = unitOrZero(sum);
    // No face here has an area, or they cancel out: any unit vector keeps the deformation defined.
    return normal != glm::dvec3(0.0) ? glm::vec3(normal) : glm::vec3(0.0f, 1.0f, 0.0f);
}

/// Of a face that has an area.
glm::vec3 CornerNormals::Reader::smoothNormal(const Face& face) const {
    glm::dvec3 sum(0.0);
    for (const Face& other : m_faces) {
        if (joins(face, other)) {
            sum += other.area;
        }
    }
    const glm::dvec3 normal = unitOrZero(sum);
    return glm::vec3(normal != glm::dvec3(0.0) ? normal : glm::dvec3(face.unit));
}

/// Whether two faces at a vertex are part of one smooth surface.
bool CornerNormals::Reader::joins(const Face& a, const Face& b) const {
    if (a.face == b.face) {
        return true;
    }
    if (const std::vector<std::uint32_t>& groups = m_all.m_mesh.faceSmoothing; !groups.empty()) {
        return groups[a.face] != 0 && groups[a.face] == groups[b.face];
    }
    // Flat steps of a tessellated surface must not flicker between joined and not joined by rounding.
    return glm::dot(glm::dvec3(a.unit), glm::dvec3(b.unit)) >= m_all.m_cosine - 1e-6;
}

/// Then the sum over those that join any of them is the sum over all. Not if that is zero: each has its own
/// then.
bool CornerNormals::Reader::areAllJoined() const {
    glm::dvec3 sum(0.0);
    for (auto face = m_faces.begin(); face != m_faces.end(); ++face) {
        sum += face->area;
        if (!std::all_of(m_faces.begin(), face, [&](const Face& other) { return joins(other, *face); })) {
            return false;
        }
    }
    return unitOrZero(sum) != glm::dvec3(0.0);
}

std::vector<glm::vec3> cornerNormals(const MeshData& mesh, float creaseAngle) {
    const VertexCorners vertexCorners(mesh);
    const CornerFaces cornerFaces(mesh);
    const CornerNormals normals(mesh, vertexCorners, cornerFaces, creaseAngle);
    std::vector<glm::vec3> list(mesh.cornerVertices.size());
    inWatchedParts(mesh.vertexCount(), kVerticesAThread, [&](std::size_t begin, std::size_t end) {
        CornerNormals::Reader reader(normals);
        for (std::size_t v = begin; v < end; ++v) {
            const std::span<const glm::vec3> ofVertex = reader.of(v);
            const std::span<const std::uint32_t> corners = vertexCorners.of(v);
            for (std::size_t i = 0; i < corners.size(); ++i) {
                list[corners[i]] = ofVertex[i];
            }
        }
    });
    return list;
}

}  // namespace hitscope
