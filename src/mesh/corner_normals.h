// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/raw_vector.h"
#include "core/sorted_by_key.h"
#include "mesh/mesh_data.h"

namespace hitscope {

/// Radians between faces from which computed normals keep them apart, where nothing else is said.
inline constexpr float kCreaseAngle = 0.7853982f;

/// The corners of every vertex: of() lists those of one, ascending.
class VertexCorners {
public:
    explicit VertexCorners(const MeshData& mesh);
    [[nodiscard]] std::span<const std::uint32_t> of(std::size_t vertex) const {
        const std::uint32_t first = m_corners.starts[vertex];
        return std::span(m_corners.numbers).subspan(first, m_corners.starts[vertex + 1] - first);
    }

private:
    KeyedNumbers<RawVector<std::uint32_t>> m_corners;
};

/// The face of every corner. `mesh` outlives this.
class CornerFaces {
public:
    explicit CornerFaces(const MeshData& mesh);
    [[nodiscard]] std::uint32_t operator[](std::uint32_t corner) const {
        return m_size == 3 ? corner / 3 : (m_size == 4 ? corner / 4 : m_faces[corner]);
    }

private:
    std::uint32_t m_size;              ///< corners that every face has, if these are 3 or 4; else 0
    RawVector<std::uint32_t> m_faces;  ///< one a corner; empty where the size tells
};

/// One unit normal a corner: the file's where it has a usable one, else computed from the faces around the
/// vertex (buildRenderMesh says how).
class CornerNormals {
public:
    /// `mesh` and the others outlive this.
    CornerNormals(const MeshData& mesh, const VertexCorners& vertexCorners, const CornerFaces& cornerFaces,
                  float creaseAngle);

    /// Looks at vertices one after the other; each thread makes its own.
    class Reader {
    public:
        explicit Reader(const CornerNormals& normals) : m_all(normals) {}
        /// Those of its corners, as VertexCorners lists them; until the next call.
        [[nodiscard]] std::span<const glm::vec3> of(std::size_t vertex);

    private:
        struct Face {
            std::uint32_t face;
            glm::dvec3 area;  ///< twice, along the normal
            glm::vec3 unit;   ///< zero for a face without area
        };
        void computeMissing(std::span<const std::uint32_t> around);
        [[nodiscard]] glm::vec3 averageNormal() const;
        [[nodiscard]] glm::vec3 smoothNormal(const Face& face) const;
        [[nodiscard]] bool joins(const Face& a, const Face& b) const;
        [[nodiscard]] bool areAllJoined() const;

        const CornerNormals& m_all;
        std::vector<glm::vec3> m_normals;
        std::vector<Face> m_faces;  ///< of the corners
    };

private:
    void measureFaces();

    const MeshData& m_mesh;
    const VertexCorners& m_vertexCorners;
    const CornerFaces& m_cornerFaces;
    double m_cosine;
    RawVector<glm::vec3> m_units;   ///< of the file's normals; zero: not usable
    RawVector<glm::dvec3> m_areas;  ///< of the faces, twice; empty: the file's normals do for all corners
};

/// The same as a list: one a corner.
[[nodiscard]] std::vector<glm::vec3> cornerNormals(const MeshData& mesh, float creaseAngle);

}  // namespace hitscope
