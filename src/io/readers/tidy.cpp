// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/tidy.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "core/finite.h"
#include "core/memory.h"
#include "core/srgb.h"
#include "io/placement_text.h"

namespace hitscope {
namespace {

constexpr double kSmallestExtent = 1e-300;  // the inverse of it is a number

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
        freeAll(indices);
    }
}

/// Where floats would not keep the shape, since it is small beside its distance from the origin: its centre,
/// in whole numbers. Else zero.
glm::dvec3 centreIfFar(const std::vector<glm::dvec3>& positions) {
    constexpr double kFar = 256.0;  // extents; floats then are 1/65,000 of one apart
    glm::dvec3 lowest = positions.front();
    glm::dvec3 highest = positions.front();
    for (const glm::dvec3& position : positions) {
        lowest = glm::min(lowest, position);
        highest = glm::max(highest, position);
    }
    const glm::dvec3 size = highest - lowest;
    const glm::dvec3 away = glm::max(glm::abs(lowest), glm::abs(highest));
    const bool isFar = std::max({away.x, away.y, away.z}) > kFar * std::max({size.x, size.y, size.z});
    return isFar ? glm::round(0.5 * lowest + 0.5 * highest) : glm::dvec3(0.0);
}

/// The largest of the sizes along the axes.
template <class Vectors>
double extentOf(const Vectors& positions) {
    glm::dvec3 lowest(std::numeric_limits<double>::infinity());
    glm::dvec3 highest(-std::numeric_limits<double>::infinity());
    for (const auto& position : positions) {
        lowest = glm::min(lowest, glm::dvec3(position));
        highest = glm::max(highest, glm::dvec3(position));
    }
    const glm::dvec3 size = highest - lowest;
    return positions.empty() ? 0.0 : std::max({size.x, size.y, size.z});
}

}  // namespace

void placeIfExtreme(ImportedMesh& imported) {
    constexpr double kSmallest = 1e-6;  // metres; far smaller ones underflow where lengths are squared
    constexpr double kLargest = 1e6;
    constexpr float kShown = 1.0f;
    const MeshData& mesh = imported.mesh;
    const double extent =
        mesh.filePositions.empty() ? extentOf(mesh.positions) : extentOf(mesh.filePositions);
    if (extent > 0.0 && (extent < kSmallest || extent > kLargest)) {
        place(imported.mesh, kShown);
        imported.notes +=
            QStringLiteral("The mesh is %1 units across, too much or too little to be shot at. ")
                .arg(extent) +
            placementText(mesh.placement) + QStringLiteral(" Exported files have its own coordinates.");
    }
}

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
    if (exact) {
        return Done{};
    }
    const double extent = extentOf(filePositions);
    if (extent > 0.0 && extent < kSmallestExtent) {
        return Error{"The mesh is smaller than numbers can tell.", "",
                     "Scale it up in the program the file came from."};
    }
    mesh.placement.centre = centreIfFar(filePositions);
    if (!mesh.placement.isIdentity()) {
        std::transform(filePositions.begin(), filePositions.end(), mesh.positions.begin(),
                       [&placement = mesh.placement](const glm::dvec3& position) {
                           return glm::vec3(placement.toLocal(position));
                       });
    }
    mesh.filePositions = std::move(filePositions);
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

void turnColoursToSrgb(MeshData& mesh) {
    for (glm::vec3& colour : mesh.colours) {
        for (int i = 0; i < 3; ++i) {
            // Of float 1 is less than 1.
            colour[i] =
                std::clamp(static_cast<float>(srgbOfLinear(static_cast<double>(colour[i]))), 0.0f, 1.0f);
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
    placeIfExtreme(imported);
    if (!mesh.placement.isIdentity() && mesh.placement.scale == 1.0) {
        imported.notes +=
            QStringLiteral("The mesh lies far from the origin, where rounding would spoil its shape. ") +
            placementText(mesh.placement) + QStringLiteral(" Exported files have its own coordinates.");
    }
    clearIfUnused(mesh.cornerTexcoords);
    clearIfUnused(mesh.cornerNormals);
    clearIfUnused(mesh.faceMaterials);
}

}  // namespace hitscope
