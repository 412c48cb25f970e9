// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/export/export_options.h"

#include <QFileInfo>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <string>

#include "deform/cluster_reach.h"
#include "deform/dent_shape.h"
#include "io/file_scope.h"
#include "io/float_text.h"
#include "session/target.h"

namespace hitscope {

namespace {

// Typical bytes, from files that other programs write.
constexpr std::uint64_t kCsvNumber = 14;   // likewise, of all digits
constexpr std::uint64_t kPlySource = 5;    // of a vertex: whether it is new, its number in the file
constexpr std::uint64_t kPlyVertex = 44;   // position, normal, displacement, its length, hits
constexpr std::uint64_t kGltfVertex = 16;  // position, number in the file
constexpr std::uint64_t kGltfNormal = 12;
constexpr std::uint64_t kGltfTexcoord = 8;
constexpr std::uint64_t kGltfText = 2500;   // its JSON
constexpr std::uint64_t kLooseVertex = 28;  // position, its change, number in the file
constexpr std::uint64_t kMorph = 12;        // change of a position, or of a normal
constexpr double kMorphStep = 900.0;        // its accessors, in the JSON
constexpr double kStepVertex = 28.0;        // that a step moves: its number, change of position and normal
constexpr std::uint64_t kFacet = 50;        // of a binary STL
constexpr std::uint64_t kPixel = 2;         // of a PNG

std::uint64_t segmentsOf(const MeshData& mesh) {
    std::uint64_t segments = 0;
    for (const std::vector<std::uint32_t>& line : mesh.lines) {
        segments += std::max<std::size_t>(line.size(), 1) - 1;
    }
    return segments;
}

/// Of the pictures that go into a glTF file or beside it: as they are, or as PNG.
std::uint64_t pictureBytes(const Target& target) {
    const MeshData& mesh = target.deformed.original();
    std::map<int, std::string> pictures;  // each once
    for (const Material& material : mesh.materials) {
        pictures.emplace(material.diffuseImage, material.diffuseTexture);
        pictures.emplace(material.normalMap.image, material.normalMap.texture);
        pictures.emplace(material.metalRoughness.image, material.metalRoughness.texture);
    }
    std::uint64_t bytes = 0;
    for (const auto& [index, name] : pictures) {
        if (index < 0) {
            continue;
        }
        const QString file =
            name.empty() || target.sourcePath.isEmpty()
                ? QString()
                : resolveTexture(QFileInfo(target.sourcePath).absolutePath(), fileNameText(name));
        const Image& image = mesh.images[static_cast<std::size_t>(index)];
        bytes += file.isEmpty() ? kPixel * static_cast<std::uint64_t>(image.width) *
                                      static_cast<std::uint64_t>(image.height)
                                : static_cast<std::uint64_t>(QFileInfo(file).size());
    }
    return bytes;
}

/// How many vertices a hit moves that reaches what is drawn as it is now.
std::size_t reachedBy(const Hit& hit, const Target& target, const ClusterReach& reach) {
    const std::span<const DynamicVertex> vertices = target.deformed.vertices();
    const std::vector<Cluster>& clusters = target.deformed.render().clusters;
    const HitReach sphere = reachOf(hit);
    std::vector<std::uint32_t> found;
    reach.find(hit, found);
    std::size_t reached = 0;
    for (const std::uint32_t cluster : found) {
        for (const DynamicVertex& vertex :
             vertices.subspan(clusters[cluster].first, clusters[cluster].count)) {
            reached += glm::distance(vertex.position, sphere.centre) <= sphere.radius ? 1 : 0;
        }
    }
    return reached;
}

/// What the steps of an animation take: as many vertices as some of the hits move, as if each struck any
/// vertex that ever moved.
std::uint64_t stepBytes(const Target& target, const ExportOptions& options, std::span<const Hit> hits) {
    constexpr std::size_t kSamples = 32;
    // Vertices around a round dent, whose normals turn, for each root of those in it.
    constexpr double kRim = 4.0;
    std::vector<std::size_t> own;
    for (std::size_t h = 0; h < hits.size(); ++h) {
        if (hits[h].enabled && hits[h].target == target.id) {
            own.push_back(h);
        }
    }
    const auto moved = static_cast<double>(target.deformed.onceChanged().size());
    if (own.empty() || moved < 1.0 || options.steps == 0) {
        return 0;
    }
    const ClusterReach reach(target.deformed.render());
    const std::size_t samples = std::min(own.size(), kSamples);
    double reached = 0.0;
    for (std::size_t s = 0; s < samples; ++s) {
        const auto inside =
            static_cast<double>(reachedBy(hits[own[s * own.size() / samples]], target, reach));
        reached += inside + kRim * std::sqrt(inside);
    }
    const double share = std::min(1.0, reached / static_cast<double>(samples) / moved);
    const auto count =
        static_cast<double>(std::min(options.steps, morphUnitCount(hits, own, options.stepOf)));
    const double ofOne = moved * (1.0 - std::pow(1.0 - share, static_cast<double>(own.size()) / count));
    return static_cast<std::uint64_t>(count * (kMorphStep + kStepVertex * ofOne));
}

bool hasNormals(const Target& target, const ExportOptions& options) {
    return target.sourcePath.isEmpty() || !target.deformed.original().normals.empty() || options.allNormals;
}

/// Without the steps of an animation.
std::uint64_t gltfBytes(const Target& target, const ExportOptions& options) {
    const MeshData& mesh = target.deformed.original();
    const bool withNormals = hasNormals(target, options);
    const bool hasTexcoords = !mesh.cornerTexcoords.empty();
    // Corners of one vertex are drawn apart for their normals and texture coordinates alone.
    const std::uint64_t drawn =
        withNormals || hasTexcoords ? target.deformed.vertices().size() : mesh.positions.size();
    const std::uint64_t ofVertex = kGltfVertex + (withNormals ? kGltfNormal : 0) +
                                   (hasTexcoords ? kGltfTexcoord : 0) + (mesh.colours.empty() ? 0 : kMorph);
    const std::uint64_t ofMorph = kMorph * (withNormals ? 2 : 1);
    const std::uint64_t changed = target.deformed.statistics().changedVertices * drawn /
                                  std::max<std::uint64_t>(1, mesh.positions.size());
    const std::uint64_t index = drawn < 0xffff ? 2 : 4;
    return kGltfText + ofVertex * drawn + std::min(ofMorph * drawn, (ofMorph + 4) * changed) +
           3 * index * (mesh.cornerVertices.size() - 2 * mesh.faceCount()) +
           (kLooseVertex + 4) * (2 * segmentsOf(mesh) + mesh.points.size()) + pictureBytes(target);
}

/// Mean bytes of coordinates as text, with a blank: of some of `count` vectors, which `at` gives.
template <typename At>
double coordinateBytes(std::size_t count, const At& at, char* (*write)(char* to, float value)) {
    constexpr std::size_t kSamples = 300;
    char text[kFloatText];
    std::size_t bytes = 0;
    const std::size_t samples = std::min(count, kSamples);
    for (std::size_t s = 0; s < samples; ++s) {
        const glm::vec3 vector = at(s * count / samples);
        for (int axis = 0; axis < 3; ++axis) {
            bytes += static_cast<std::size_t>(write(text, vector[axis]) - text) + 1;
        }
    }
    return samples > 0 ? static_cast<double>(bytes) / (3.0 * static_cast<double>(samples)) : 0.0;
}

double positionBytes(const MeshData& mesh) {
    const auto at = [&mesh](std::size_t vertex) {
        return mesh.filePositions.empty() ? mesh.positions[vertex] : glm::vec3(mesh.filePositions[vertex]);
    };
    return coordinateBytes(mesh.positions.size(), at, &writeFloat);
}

double normalBytes(const Target& target) {
    const std::span<const DynamicVertex> vertices = target.deformed.vertices();
    const auto at = [vertices](std::size_t vertex) { return vertices[vertex].normal; };
    return coordinateBytes(vertices.size(), at, &writeSixDecimals);
}

double texcoordBytes(const MeshData& mesh) {
    const auto at = [&mesh](std::size_t index) {
        const glm::vec2& place = mesh.texcoords[index];
        return glm::vec3(place, 0.5f * (place.x + place.y));
    };
    return coordinateBytes(mesh.texcoords.size(), at, &writeFloat);
}

/// Mean bytes of the numbers from 1 to `count`, with a blank.
double indexBytes(std::size_t count) {
    const auto all = static_cast<double>(std::max<std::size_t>(count, 1));
    const double digits = std::floor(std::log10(all)) + 1.0;
    return 1.0 + digits * (all + 1.0) / all - (std::pow(10.0, digits) - 1.0) / (9.0 * all);
}

/// Of an OBJ that is written anew.
double objBytes(const Target& target, const ExportOptions& options) {
    const MeshData& mesh = target.deformed.original();
    const auto vertices = static_cast<double>(mesh.positions.size());
    const auto texcoords = static_cast<double>(mesh.texcoords.size());
    const bool withNormals = hasNormals(target, options);
    const std::size_t distinct =
        mesh.normals.empty() ? target.deformed.vertices().size() : mesh.normals.size();
    const std::size_t normals = withNormals ? distinct : 0;
    const double numberOfNormal =
        indexBytes(normals) + (mesh.texcoords.empty() ? 1.0 : 0.0);  // "7//3", "7/2/3"
    const double ofCorner = indexBytes(mesh.positions.size()) +
                            (mesh.texcoords.empty() ? 0.0 : indexBytes(mesh.texcoords.size())) +
                            (withNormals ? numberOfNormal : 0.0);
    return vertices * (2.0 + 3.0 * positionBytes(mesh)) + texcoords * (3.0 + 2.0 * texcoordBytes(mesh)) +
           static_cast<double>(normals) * (3.0 + 3.0 * normalBytes(target)) +
           static_cast<double>(mesh.cornerVertices.size()) * ofCorner +
           2.0 * static_cast<double>(mesh.faceCount());
}

/// Of a PLY as text.
double plyTextBytes(const Target& target) {
    const MeshData& mesh = target.deformed.original();
    const auto vertices = static_cast<double>(mesh.positions.size());
    const auto changed = static_cast<double>(target.deformed.statistics().changedVertices);
    const double source = mesh.isAsRead() ? 0.0 : 2.0 + indexBytes(mesh.positions.size());
    // Of what has not moved, the displacement, its length and the hits are zeros.
    return vertices * (3.0 * positionBytes(mesh) + 3.0 * normalBytes(target) + 10.0 + source) +
           changed * 4.0 * static_cast<double>(kCsvNumber - 2) +
           static_cast<double>(mesh.cornerVertices.size()) *
               (indexBytes(mesh.positions.size()) +
                (mesh.cornerTexcoords.empty() ? 0.0 : 2.0 * texcoordBytes(mesh))) +
           2.0 * static_cast<double>(mesh.faceCount()) +
           2.0 * indexBytes(mesh.positions.size()) * static_cast<double>(segmentsOf(mesh));
}

/// isAlone: in the file.
std::uint64_t bytesOf(const Target& target, const ExportOptions& options, bool isAlone,
                      std::span<const Hit> hits) {
    const MeshData& mesh = target.deformed.original();
    const std::uint64_t vertices = mesh.positions.size();
    const std::uint64_t corners = mesh.cornerVertices.size();
    const std::uint64_t faces = mesh.faceCount();
    const bool hasTexcoords = !mesh.cornerTexcoords.empty();
    switch (options.format) {
        case ExportFormat::Obj: {
            const QFileInfo source(target.sourcePath);
            const bool isCopy = isAlone && mesh.isAsRead() && source.exists() &&
                                exportFormatOf(target.sourcePath) == ExportFormat::Obj;
            return isCopy ? static_cast<std::uint64_t>(source.size())
                          : static_cast<std::uint64_t>(objBytes(target, options));
        }
        case ExportFormat::Ply:
            return (kPlyVertex + (mesh.isAsRead() ? 0 : kPlySource)) * vertices + 4 * corners + faces +
                   (hasTexcoords ? 8 * corners + faces : 0) + 8 * segmentsOf(mesh);
        case ExportFormat::PlyAscii:
            return static_cast<std::uint64_t>(plyTextBytes(target));
        case ExportFormat::Stl:
            return kFacet * (corners - 2 * faces);
        case ExportFormat::Glb:
        case ExportFormat::Gltf:
            return gltfBytes(target, options) + stepBytes(target, options, hits);
        case ExportFormat::Csv:
            break;
    }
    return 12 * kCsvNumber * target.deformed.statistics().changedVertices;
}

}  // namespace

const std::array<ExportFormatTraits, 7>& exportFormats() {
    static constexpr std::array<ExportFormatTraits, 7> kFormats{{
        {ExportFormat::Obj, "obj", "obj", "Wavefront OBJ", true, false},
        {ExportFormat::Ply, "ply", "ply", "PLY, binary", true, false},
        {ExportFormat::PlyAscii, "ply-ascii", "ply", "PLY, as text", true, false},
        {ExportFormat::Stl, "stl", "stl", "STL", false, false},
        {ExportFormat::Glb, "glb", "glb", "glTF in one file (GLB)", true, true},
        {ExportFormat::Gltf, "gltf", "gltf", "glTF", true, true},
        {ExportFormat::Csv, "csv", "csv", "CSV, the vertices that moved", false, false},
    }};
    return kFormats;
}

const ExportFormatTraits& traitsOf(ExportFormat format) {
    return exportFormats()[static_cast<std::size_t>(format)];
}

std::optional<ExportFormat> exportFormatOf(const QString& path) {
    const QString suffix = QFileInfo(path).suffix().toLower();
    const auto& formats = exportFormats();
    const auto found = std::find_if(formats.begin(), formats.end(), [&suffix](const auto& traits) {
        return suffix == QLatin1String(traits.suffix);
    });
    return found == formats.end() ? std::nullopt : std::optional(found->format);
}

ExportEstimate estimateExport(std::span<const Target* const> targets, const ExportOptions& options,
                              std::span<const Hit> hits) {
    ExportEstimate estimate;
    for (const Target* target : targets) {
        const MeshData& mesh = target->deformed.original();
        const bool isTable = options.format == ExportFormat::Csv;
        estimate.vertices += isTable ? target->deformed.statistics().changedVertices : mesh.positions.size();
        estimate.faces += isTable ? 0 : mesh.faceCount();
        estimate.bytes += bytesOf(*target, options, targets.size() == 1, hits);
    }
    return estimate;
}

}  // namespace hitscope
