// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/tidy.h"

#include <algorithm>
#include <cmath>

#include "core/finite.h"

namespace hitscope {
namespace {

/// Corners whose value is missing or not finite get kNoIndex; gives their number.
template <class Vector>
std::size_t dropBadCorners(std::vector<std::uint32_t>& corners, std::vector<Vector>& values) {
    std::size_t dropped = 0;
    for (std::uint32_t& corner : corners) {
        if (corner != kNoIndex && (corner >= values.size() || !isFinite(values[corner]))) {
            corner = kNoIndex;
            ++dropped;
        }
    }
    std::replace_if(
        values.begin(), values.end(), [](const Vector& v) { return !isFinite(v); }, Vector(0.0f));
    return dropped;
}

void clearIfUnused(std::vector<std::uint32_t>& indices) {
    if (std::all_of(indices.begin(), indices.end(), [](std::uint32_t i) { return i == kNoIndex; })) {
        indices = {};
    }
}

}  // namespace

QString counted(std::size_t count, const char* one, const char* many) {
    return QString::number(count) + QLatin1Char(' ') + QString::fromUtf8(count == 1 ? one : many);
}

Status setPositions(MeshData& mesh, std::vector<glm::dvec3> filePositions) {
    mesh.positions.resize(filePositions.size());
    bool exact = true;
    for (std::size_t v = 0; v < filePositions.size(); ++v) {
        mesh.positions[v] = glm::vec3(filePositions[v]);
        if (!isFinite(mesh.positions[v])) {
            return Error{"A coordinate is not a number, infinite or too large.",
                         "vertex " + std::to_string(v + 1),
                         "Repair or remove this vertex in the program the file came from."};
        }
        exact = exact && glm::dvec3(mesh.positions[v]) == filePositions[v];
    }
    mesh.filePositions = exact ? std::vector<glm::dvec3>() : std::move(filePositions);
    return Done{};
}

void setColours(MeshData& mesh, std::vector<glm::vec3> colours) {
    const bool bytes = std::any_of(colours.begin(), colours.end(), [](const glm::vec3& colour) {
        return colour.x > 1.0f || colour.y > 1.0f || colour.z > 1.0f;
    });
    for (glm::vec3& colour : colours) {
        for (int i = 0; i < 3; ++i) {
            const float value = bytes ? colour[i] / 255.0f : colour[i];
            colour[i] = std::isfinite(value) ? std::clamp(value, 0.0f, 1.0f) : 1.0f;
        }
    }
    mesh.colours = std::move(colours);
}

/// IEC 61966-2-1.
void turnColoursToSrgb(MeshData& mesh) {
    for (glm::vec3& colour : mesh.colours) {
        for (int i = 0; i < 3; ++i) {
            const float light = colour[i];
            colour[i] = light <= 0.0031308f ? 12.92f * light : 1.055f * std::pow(light, 1.0f / 2.4f) - 0.055f;
            colour[i] = std::clamp(colour[i], 0.0f, 1.0f);
        }
    }
}

void tidy(ImportedMesh& imported) {
    MeshData& mesh = imported.mesh;
    if (const std::size_t bad = dropBadCorners(mesh.cornerTexcoords, mesh.texcoords)) {
        imported.notes +=
            counted(bad, "face corner refers to texture coordinates that the file lacks; it has none.",
                    "face corners refer to texture coordinates that the file lacks; they have none.");
    }
    if (const std::size_t bad = dropBadCorners(mesh.cornerNormals, mesh.normals)) {
        imported.notes += counted(bad, "face corner refers to a normal that the file lacks; it is computed.",
                                  "face corners refer to normals that the file lacks; they are computed.");
    }
    clearIfUnused(mesh.cornerTexcoords);
    clearIfUnused(mesh.cornerNormals);
    clearIfUnused(mesh.faceMaterials);
}

}  // namespace hitscope
