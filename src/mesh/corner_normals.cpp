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
constexpr std::size_t kVerticesAThread = 4096;
constexpr std::size_t kFacesAThread = 16384;

/// The zero vector when v has no usable direction.
glm::dvec3 unitOrZero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return std::isfinite(length) && length > 0.0 ? v / length : glm::dvec3(0.0);
}

/// Whether two faces at a vertex are part of one smooth surface.
class Smoothness {
public:
    Smoothness(const MeshData& mesh, float creaseAngle)
        : m_groups(mesh.faceSmoothing), m_cosine(std::cos(static_cast<double>(creaseAngle))) {}

    [[nodiscard]] bool joins(std::uint32_t face, std::uint32_t other, const glm::dvec3& faceNormal,
                             const glm::dvec3& otherNormal) const {
        if (face == other) {
            return true;
        }
        if (!m_groups.empty()) {
            return m_groups[face] != 0 && m_groups[face] == m_groups[other];
        }
        // Flat steps of a tessellated surface must not flicker between joined and not joined by rounding.
        return glm::dot(faceNormal, otherNormal) >= m_cosine - 1e-6;
    }

private:
    const std::vector<std::uint32_t>& m_groups;
    double m_cosine;
};

struct FaceNormals {
    std::vector<std::uint32_t> faceOfCorner;
    std::vector<glm::dvec3> areas;  ///< twice the area, along the normal
    std::vector<glm::vec3> units;   ///< zero for a face without area

    explicit FaceNormals(const MeshData& mesh)
        : faceOfCorner(mesh.cornerVertices.size()), areas(mesh.faceCount()), units(mesh.faceCount()) {
        inWatchedParts(mesh.faceCount(), kFacesAThread, [&](std::size_t begin, std::size_t end) {
            for (std::size_t f = begin; f < end; ++f) {
                for (std::size_t c = mesh.faceStarts[f]; c < mesh.faceStarts[f + 1]; ++c) {
                    faceOfCorner[c] = static_cast<std::uint32_t>(f);
                }
                areas[f] = doubleAreaVector(mesh.positions, mesh.face(f));
                units[f] = glm::vec3(unitOrZero(areas[f]));
            }
        });
    }
};

glm::vec3 averageNormal(std::span<const std::uint32_t> around, const FaceNormals& faces) {
    glm::dvec3 sum(0.0);
    for (const std::uint32_t corner : around) {
        sum += faces.areas[faces.faceOfCorner[corner]];
    }
    const glm::dvec3 normal = unitOrZero(sum);
    // No face here has an area, or they cancel out: any unit vector keeps the deformation defined.
    return normal != glm::dvec3(0.0) ? glm::vec3(normal) : glm::vec3(0.0f, 1.0f, 0.0f);
}

/// Of a corner whose face has an area.
glm::vec3 smoothNormal(std::uint32_t corner, std::span<const std::uint32_t> around, const FaceNormals& faces,
                       const Smoothness& smoothness) {
    const std::uint32_t face = faces.faceOfCorner[corner];
    const glm::dvec3 own(faces.units[face]);
    glm::dvec3 sum(0.0);
    for (const std::uint32_t other : around) {
        const std::uint32_t otherFace = faces.faceOfCorner[other];
        if (smoothness.joins(face, otherFace, own, glm::dvec3(faces.units[otherFace]))) {
            sum += faces.areas[otherFace];
        }
    }
    const glm::dvec3 normal = unitOrZero(sum);
    return glm::vec3(normal != glm::dvec3(0.0) ? normal : own);
}

/// Fills the zero vectors among the normals of a vertex's corners.
void computeMissing(std::span<const std::uint32_t> around, const FaceNormals& faces,
                    const Smoothness& smoothness, std::vector<glm::vec3>& normals) {
    const auto isMissing = [&normals](std::uint32_t corner) { return normals[corner] == glm::vec3(0.0f); };
    if (std::none_of(around.begin(), around.end(), isMissing)) {
        return;
    }
    const glm::vec3 average = averageNormal(around, faces);
    for (const std::uint32_t corner : around) {
        if (!isMissing(corner)) {
            continue;
        }
        const bool isAveraged =
            around.size() > kMostFacesCompared || faces.units[faces.faceOfCorner[corner]] == glm::vec3(0.0f);
        normals[corner] = isAveraged ? average : smoothNormal(corner, around, faces, smoothness);
    }
}

}  // namespace

VertexCorners::VertexCorners(const MeshData& mesh)
    : starts(mesh.vertexCount() + 1, 0), corners(mesh.cornerVertices.size()) {
    for (std::size_t c = 0; c < corners.size(); ++c) {
        mayGiveUp(c);
        ++starts[mesh.cornerVertices[c] + 1];
    }
    for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
        starts[v + 1] += starts[v];
    }
    std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
    for (std::size_t c = 0; c < corners.size(); ++c) {
        mayGiveUp(c);
        corners[next[mesh.cornerVertices[c]]++] = static_cast<std::uint32_t>(c);
    }
}

bool CornerNormals::isComplete() const {
    return m_mesh.cornerNormals.size() == m_mesh.cornerVertices.size() &&
           std::all_of(m_mesh.cornerNormals.begin(), m_mesh.cornerNormals.end(),
                       [this](std::uint32_t n) { return n != kNoIndex && m_units[n] != glm::vec3(0.0f); });
}

CornerNormals::CornerNormals(const MeshData& mesh, const VertexCorners& vertexCorners, float creaseAngle)
    : m_mesh(mesh) {
    m_units.reserve(mesh.normals.size());
    for (const glm::vec3& normal : mesh.normals) {
        mayGiveUp(m_units.size());
        m_units.emplace_back(unitOrZero(glm::dvec3(normal)));
    }
    if (isComplete()) {
        return;
    }
    m_ofCorners.assign(mesh.cornerVertices.size(), glm::vec3(0.0f));
    for (std::size_t c = 0; c < mesh.cornerNormals.size(); ++c) {
        mayGiveUp(c);
        if (mesh.cornerNormals[c] != kNoIndex) {
            m_ofCorners[c] = m_units[mesh.cornerNormals[c]];
        }
    }
    const FaceNormals faces(mesh);
    const Smoothness smoothness(mesh, creaseAngle);
    // The corners of a vertex are its own: parts write to different ones.
    inWatchedParts(mesh.vertexCount(), kVerticesAThread, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            computeMissing(vertexCorners.of(v), faces, smoothness, m_ofCorners);
        }
    });
}

std::vector<glm::vec3> cornerNormals(const MeshData& mesh, float creaseAngle) {
    const VertexCorners vertexCorners(mesh);
    const CornerNormals normals(mesh, vertexCorners, creaseAngle);
    std::vector<glm::vec3> list;
    list.reserve(mesh.cornerVertices.size());
    for (std::size_t corner = 0; corner < mesh.cornerVertices.size(); ++corner) {
        mayGiveUp(corner);
        list.push_back(normals[corner]);
    }
    return list;
}

}  // namespace hitscope
