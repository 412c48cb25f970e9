// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/bounds.h"
#include "core/image.h"
#include "core/page_vector.h"
#include "core/result.h"

namespace hitscope {

/// A tangent-space normal map: red along the texture's u, green along its v (upwards), blue outwards.
struct NormalMap {
    /// What the file calls it; a bump map counts as one, unless it holds heights.
    enum class Kind : std::uint8_t { Normals, Bump };
    Kind kind = Kind::Normals;
    std::string texture;    ///< path as the file names it; empty: none, or it is in the file
    float strength = 1.0f;  ///< what scales red and green
    int image = -1;         ///< index into MeshData::images; -1: none, or it could not be read
};

/// How a surface reflects in glTF's terms (metallic-roughness). The texture's green scales roughness, its
/// blue metalness.
struct MetalRoughness {
    float metalness = 0.0f;   ///< [0, 1]
    float roughness = -1.0f;  ///< [0, 1]; negative: the file does not describe the surface so
    std::string texture;      ///< path as the file names it; empty: none, or it is in the file
    int image = -1;           ///< index into MeshData::images; -1: none, or it could not be read

    [[nodiscard]] bool isGiven() const { return roughness >= 0.0f; }
};

/// Surface description in Phong's terms (paper, section 2.5), as OBJ's MTL has it.
struct Material {
    std::string name;
    glm::vec3 ambient{0.2f};     ///< linear factor, [0, 1]
    glm::vec3 diffuse{0.8f};     ///< linear factor, [0, 1]
    glm::vec3 specular{0.3f};    ///< linear factor, [0, 1]
    float shininess = 32.0f;     ///< Phong exponent, > 0
    float opacity = 1.0f;        ///< [0, 1]
    std::string diffuseTexture;  ///< path as the file names it (relative to the file's folder); empty: none
    int diffuseImage = -1;       ///< index into MeshData::images; -1: none, or it could not be read
    NormalMap normalMap;
    MetalRoughness metalRoughness;
};

/// A named run of faces, from OBJ's o and g lines or the node of another format.
struct FaceGroup {
    enum class Kind : std::uint8_t { Object, Group };
    Kind kind = Kind::Group;
    std::string name;
    std::uint32_t firstFace =
        0;  ///< the group starts before this face; it ends where the next of its kind starts
};

/// How a mesh was moved and scaled when it was loaded: local = (file - centre) * scale.
/// Identity unless the person asked for it, so that the file's own coordinates come back on export.
struct Placement {
    glm::dvec3 centre{0.0};
    double scale = 1.0;
    bool operator==(const Placement&) const = default;
    [[nodiscard]] bool isIdentity() const { return *this == Placement{}; }
    [[nodiscard]] glm::dvec3 toLocal(const glm::dvec3& file) const { return (file - centre) * scale; }
    [[nodiscard]] glm::dvec3 toFile(const glm::dvec3& local) const { return local / scale + centre; }
};

inline constexpr std::uint32_t kNoIndex = 0xffffffffu;

/// A polygon mesh as its file has it: the file's own vertex order, polygons, indices and groups. Immutable
/// once it is a target's original; what hits do to it is kept elsewhere (DeformedMesh).
///
/// Index arrays are either empty (the mesh has none of that) or exactly as long as said here.
struct MeshData {
    std::string name;  ///< for people: the file's base name, or "Low-poly sphere 3"

    PageVector<glm::vec3> positions;  ///< metres, local frame; V entries, vertices no face uses included
    std::vector<glm::dvec3> filePositions;  ///< empty or V entries: the file's own numbers, before placement
    Placement placement;                    ///< relates filePositions to positions
    std::vector<glm::vec3> colours;         ///< empty or V entries, sRGB in [0, 1]
    std::vector<glm::vec3> normals;         ///< the file's normals, any number (unit not guaranteed)
    std::vector<glm::vec2> texcoords;  ///< the file's texture coordinates, any number; v upwards, as in OBJ

    std::vector<std::uint32_t> faceStarts;       ///< F + 1 entries (or empty: no faces): face f has corners
                                                 ///< [faceStarts[f], faceStarts[f + 1]), at least 3
    std::vector<std::uint32_t> cornerVertices;   ///< C entries < V
    std::vector<std::uint32_t> cornerTexcoords;  ///< empty or C entries < texcoords.size(), or kNoIndex
    std::vector<std::uint32_t> cornerNormals;    ///< empty or C entries < normals.size(), or kNoIndex
    std::vector<std::uint32_t> faceMaterials;    ///< empty or F entries < materials.size(), or kNoIndex
    std::vector<std::uint32_t> faceSmoothing;    ///< empty or F entries: OBJ smoothing group, 0 = off

    std::vector<FaceGroup> groups;                  ///< sorted by firstFace
    std::vector<Material> materials;                ///< in the file's order
    std::vector<Image> images;                      ///< decoded textures the materials refer to
    std::vector<std::vector<std::uint32_t>> lines;  ///< OBJ l elements: vertex indices; kept for export only
    std::vector<std::uint32_t> points;              ///< OBJ p elements: vertex indices; kept for export only
    std::vector<std::string> materialLibraries;     ///< OBJ mtllib names, as the file has them
    std::uint64_t sourceHash = 0;  ///< contentHash() of the OBJ or PLY file it was read from; 0: not known
    /// Empty: the vertices are those of the file. Else (refined, simplified, smoothed) V entries: a vertex's
    /// number in the file, kNoIndex: it is new.
    std::vector<std::uint32_t> sourceVertices;
    std::vector<std::string> pictureFiles;  ///< textures, as the file names them, whose files are pictures

    [[nodiscard]] std::size_t vertexCount() const { return positions.size(); }
    [[nodiscard]] std::size_t faceCount() const { return faceStarts.empty() ? 0 : faceStarts.size() - 1; }
    /// The vertices of face f, in order. 0 <= f < faceCount().
    [[nodiscard]] std::span<const std::uint32_t> face(std::size_t f) const {
        return std::span(cornerVertices).subspan(faceStarts[f], faceStarts[f + 1] - faceStarts[f]);
    }
    [[nodiscard]] Bounds bounds() const;
    /// Whether it is what was read or made, and nothing was done to it since (sourceVertices).
    [[nodiscard]] bool isAsRead() const { return sourceVertices.empty(); }
    [[nodiscard]] bool isNew(std::size_t vertex) const {
        return !sourceVertices.empty() && sourceVertices[vertex] == kNoIndex;
    }
};

/// Checks every length and index above and that all positions are finite; the error names the first that is
/// wrong. Whatever comes from a file or another process passes through here before anything else sees it.
[[nodiscard]] Status validate(const MeshData& mesh);

/// Moves the mesh's centre to the origin and scales it so that its largest extent is `extent` metres; fills
/// filePositions and placement so that export gives the file's own coordinates back. extent > 0.
void place(MeshData& mesh, float extent);

}  // namespace hitscope
