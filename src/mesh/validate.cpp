// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <string>

#include "mesh/mesh_data.h"

#include "core/finite.h"

namespace hitscope {
namespace {

const char* const kBroken = "The mesh is damaged: write the file again with the program it came from.";

bool isColour(const glm::vec3& c) {
    return c.x >= 0.0f && c.x <= 1.0f && c.y >= 0.0f && c.y <= 1.0f && c.z >= 0.0f && c.z <= 1.0f;
}

/// "vertex 12", counted from one as people and OBJ do.
std::string nth(const char* thing, std::size_t index) {
    return std::string(thing) + " " + std::to_string(index + 1);
}

Error wrongLength(const std::string& what, std::size_t has, std::size_t needs) {
    return {
        "There are " + std::to_string(has) + " " + what + " where " + std::to_string(needs) + " are needed.",
        what, kBroken};
}

Error badIndex(const std::string& where, const char* thing, std::size_t index, std::size_t count) {
    return {"It refers to " + nth(thing, index) + ", but the mesh has " + std::to_string(count) + ".", where,
            kBroken};
}

Status checkCounts(const MeshData& mesh) {
    for (const auto& [what, count] :
         {std::pair{"vertices", mesh.positions.size()}, std::pair{"face corners", mesh.cornerVertices.size()},
          std::pair{"faces", mesh.faceStarts.size()}, std::pair{"normals", mesh.normals.size()},
          std::pair{"texture coordinates", mesh.texcoords.size()},
          std::pair{"materials", mesh.materials.size()}}) {
        if (count >= kNoIndex) {
            return Error{"There are " + std::to_string(count) + " " + what + "; at most 4,294,967,294 fit.",
                         what, "Split the mesh into smaller files."};
        }
    }
    return Done{};
}

Status checkVertices(const MeshData& mesh) {
    const std::size_t vertices = mesh.positions.size();
    for (std::size_t v = 0; v < vertices; ++v) {
        if (!isFinite(mesh.positions[v])) {
            return Error{"A coordinate is infinite or not a number.", nth("vertex", v),
                         "Repair or remove this vertex in the program the file came from."};
        }
    }
    if (!mesh.filePositions.empty() && mesh.filePositions.size() != vertices) {
        return wrongLength("file positions", mesh.filePositions.size(), vertices);
    }
    for (std::size_t v = 0; v < mesh.filePositions.size(); ++v) {
        if (!isFinite(mesh.filePositions[v])) {
            return Error{"A coordinate in the file is infinite or not a number.", nth("vertex", v),
                         "Repair or remove this vertex in the program the file came from."};
        }
    }
    if (!isFinite(mesh.placement.centre) || !std::isfinite(mesh.placement.scale) ||
        mesh.placement.scale <= 0.0) {
        return Error{"The placement's centre or scale is not a usable number.", "placement", kBroken};
    }
    if (!mesh.sourceVertices.empty() && mesh.sourceVertices.size() != vertices) {
        return wrongLength("source vertices", mesh.sourceVertices.size(), vertices);
    }
    if (!mesh.colours.empty() && mesh.colours.size() != vertices) {
        return wrongLength("vertex colours", mesh.colours.size(), vertices);
    }
    for (std::size_t v = 0; v < mesh.colours.size(); ++v) {
        if (!isColour(mesh.colours[v])) {
            return Error{"A colour is not between 0 and 1.", nth("vertex", v), kBroken};
        }
    }
    return Done{};
}

Status checkFaceStarts(const MeshData& mesh) {
    const std::size_t corners = mesh.cornerVertices.size();
    if (mesh.faceStarts.empty()) {
        return corners == 0 ? Status(Done{}) : Status(wrongLength("face corners", corners, 0));
    }
    if (mesh.faceStarts.front() != 0 || mesh.faceStarts.back() != corners) {
        return Error{"The faces do not cover their corners.", "face starts", kBroken};
    }
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        if (mesh.faceStarts[f + 1] < mesh.faceStarts[f] || mesh.faceStarts[f + 1] - mesh.faceStarts[f] < 3) {
            return Error{"A face needs at least three corners.", nth("face", f), kBroken};
        }
        // Before the whole array is known to ascend, a start beyond the end would pass the test above.
        if (mesh.faceStarts[f + 1] > corners) {
            return Error{"The face's corners lie beyond the last one.", nth("face", f), kBroken};
        }
    }
    return Done{};
}

/// One index a corner into an array of `count` things; kNoIndex is allowed where `optional`.
Status checkCorners(const MeshData& mesh, const std::vector<std::uint32_t>& indices, const char* thing,
                    std::size_t count, bool optional) {
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        for (std::size_t c = mesh.faceStarts[f]; c < mesh.faceStarts[f + 1]; ++c) {
            if (indices[c] >= count && !(optional && indices[c] == kNoIndex)) {
                return badIndex(nth("face", f), thing, indices[c], count);
            }
        }
    }
    return Done{};
}

Status checkFaces(const MeshData& mesh) {
    if (Status status = checkFaceStarts(mesh); !status) {
        return status;
    }
    if (Status status = checkCorners(mesh, mesh.cornerVertices, "vertex", mesh.vertexCount(), false);
        !status) {
        return status;
    }
    const std::size_t corners = mesh.cornerVertices.size();
    if (!mesh.cornerTexcoords.empty()) {
        if (mesh.cornerTexcoords.size() != corners) {
            return wrongLength("texture indices of corners", mesh.cornerTexcoords.size(), corners);
        }
        if (Status status =
                checkCorners(mesh, mesh.cornerTexcoords, "texture coordinate", mesh.texcoords.size(), true);
            !status) {
            return status;
        }
    }
    if (!mesh.cornerNormals.empty()) {
        if (mesh.cornerNormals.size() != corners) {
            return wrongLength("normal indices of corners", mesh.cornerNormals.size(), corners);
        }
        if (Status status = checkCorners(mesh, mesh.cornerNormals, "normal", mesh.normals.size(), true);
            !status) {
            return status;
        }
    }
    if (!mesh.faceSmoothing.empty() && mesh.faceSmoothing.size() != mesh.faceCount()) {
        return wrongLength("smoothing groups of faces", mesh.faceSmoothing.size(), mesh.faceCount());
    }
    return Done{};
}

Status checkMaterials(const MeshData& mesh) {
    if (!mesh.faceMaterials.empty() && mesh.faceMaterials.size() != mesh.faceCount()) {
        return wrongLength("materials of faces", mesh.faceMaterials.size(), mesh.faceCount());
    }
    for (std::size_t f = 0; f < mesh.faceMaterials.size(); ++f) {
        if (mesh.faceMaterials[f] >= mesh.materials.size() && mesh.faceMaterials[f] != kNoIndex) {
            return badIndex(nth("face", f), "material", mesh.faceMaterials[f], mesh.materials.size());
        }
    }
    for (std::size_t m = 0; m < mesh.materials.size(); ++m) {
        const MetalRoughness& metal = mesh.materials[m].metalRoughness;
        for (const int image :
             {mesh.materials[m].diffuseImage, mesh.materials[m].normalMap.image, metal.image}) {
            if (image < -1 || (image >= 0 && static_cast<std::size_t>(image) >= mesh.images.size())) {
                return Error{"It refers to a texture that the mesh does not have.", nth("material", m),
                             kBroken};
            }
        }
        const NormalMap& map = mesh.materials[m].normalMap;
        if (map.kind > NormalMap::Kind::Bump || !std::isfinite(map.strength)) {
            return Error{"Its normal map is of no known kind.", nth("material", m), kBroken};
        }
        if (!(metal.metalness >= 0.0f && metal.metalness <= 1.0f && metal.roughness <= 1.0f)) {
            return Error{"Its metalness or roughness is not between 0 and 1.", nth("material", m), kBroken};
        }
    }
    for (std::size_t i = 0; i < mesh.images.size(); ++i) {
        const Image& image = mesh.images[i];
        if (image.width < 0 || image.height < 0 ||
            image.pixels.size() !=
                4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height)) {
            return Error{"Its pixels do not match its width and height.", nth("texture", i), kBroken};
        }
    }
    return Done{};
}

Status checkGroupsAndElements(const MeshData& mesh) {
    std::uint32_t previous = 0;
    for (std::size_t g = 0; g < mesh.groups.size(); ++g) {
        const FaceGroup& group = mesh.groups[g];
        if (group.kind != FaceGroup::Kind::Object && group.kind != FaceGroup::Kind::Group) {
            return Error{"It is neither an object nor a group.", nth("group", g), kBroken};
        }
        if (group.firstFace < previous || group.firstFace > mesh.faceCount()) {
            return Error{"It starts before the group in front of it or behind the last face.",
                         nth("group", g), kBroken};
        }
        previous = group.firstFace;
    }
    for (std::size_t l = 0; l < mesh.lines.size(); ++l) {
        for (const std::uint32_t vertex : mesh.lines[l]) {
            if (vertex >= mesh.vertexCount()) {
                return badIndex(nth("line", l), "vertex", vertex, mesh.vertexCount());
            }
        }
    }
    for (std::size_t p = 0; p < mesh.points.size(); ++p) {
        if (mesh.points[p] >= mesh.vertexCount()) {
            return badIndex(nth("point", p), "vertex", mesh.points[p], mesh.vertexCount());
        }
    }
    return Done{};
}

}  // namespace

Status validate(const MeshData& mesh) {
    for (const auto check :
         {checkCounts, checkVertices, checkFaces, checkMaterials, checkGroupsAndElements}) {
        if (Status status = check(mesh); !status) {
            return status;
        }
    }
    return Done{};
}

}  // namespace hitscope
