// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/writers/mesh_export.h"

namespace hitscope {

/// Faces of one object with one material, its lines or its points, as glTF has them: a vertex has one index
/// for all that it has.
struct GltfPrimitive {
    /// Numbers are glTF's modes.
    enum class Kind : std::uint8_t { Points = 0, Lines = 1, Triangles = 4 };
    Kind kind = Kind::Triangles;
    std::uint32_t object = 0;
    std::uint32_t material = kNoIndex;        ///< of the mesh
    std::vector<std::uint32_t> fileVertices;  ///< one a glTF vertex: the first `ownVertices` ascend
    std::vector<std::uint32_t> corners;       ///< one a glTF vertex: whose normal and texture coordinate it
                                              ///< has; kNoIndex: no face uses it
    std::size_t ownVertices = 0;              ///< behind them: file vertices that are there once more
    std::vector<std::uint32_t> indices;       ///< 3 a triangle, 2 a line, 1 a point

    /// Appends the glTF vertices of a file vertex.
    void findVertices(std::uint32_t fileVertex, std::vector<std::uint32_t>& found) const;
    void sortCopies();  ///< after the last vertex has come

private:
    std::vector<std::uint32_t> m_copies;  ///< glTF vertices behind the first, by their file vertices
};

/// A mesh as glTF's one index for each vertex has it. Primitives come in the order of their objects, an
/// object's lines and points behind its faces; vertices that nothing uses are in the first one.
struct GltfLayout {
    std::vector<std::string> objects;  ///< names; those with faces, or one without
    std::vector<GltfPrimitive> primitives;
};

/// Lines and points of an object, as vertices of the file.
struct LooseElements {
    std::vector<std::uint32_t> segments;  ///< of lines, 2 each
    std::vector<std::uint32_t> points;
};

/// One for each of GltfLayout::objects, or empty where the mesh has no lines and points. A line is of the
/// first object that has a face at the line's first vertex, a point likewise; of the first object where none
/// has.
[[nodiscard]] std::vector<LooseElements> looseElements(const MeshData& mesh);

/// Normals before the deformation, one a corner, or empty.
[[nodiscard]] std::vector<glm::vec3> originalNormals(const MeshExport& what);

[[nodiscard]] GltfLayout layOut(const MeshExport& what, std::span<const glm::vec3> originalNormals);

}  // namespace hitscope
