// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/writers/coordinate_check.h"

#include <atomic>
#include <cmath>
#include <limits>
#include <vector>

#include "core/finite.h"
#include "core/give_up.h"
#include "core/parallel.h"
#include "io/writers/file_positions.h"

namespace hitscope {
namespace {

/// What an edge of rounding cannot take beyond the largest float.
constexpr double kMost = 0.999999 * static_cast<double>(std::numeric_limits<float>::max());

Error tooLarge(std::size_t vertex, const char* how, const QString& path) {
    return {"Vertex " + std::to_string(vertex + 1) + how +
                " than the largest number that a mesh file holds, 3.4e38.",
            path.toStdString(),
            "Export in the coordinates of the scene, or scale the mesh down in the program it came from."};
}

Error tooFarOut(std::size_t vertex, const QString& path) {
    return tooLarge(vertex, " is farther from the origin", path);
}

bool areFloats(const glm::dvec3& position) {
    return std::isfinite(static_cast<float>(position.x)) && std::isfinite(static_cast<float>(position.y)) &&
           std::isfinite(static_cast<float>(position.z));
}

/// The first of so many vertices of which that is true; their number: none.
template <class IsSo>
std::size_t firstOf(std::size_t count, const IsSo& isSo) {
    constexpr std::size_t kLeastPart = std::size_t{1} << 17;
    std::atomic<std::size_t> first = count;
    inWatchedParts(count, kLeastPart, [&](std::size_t from, std::size_t end) {
        for (std::size_t v = from; v < end; ++v) {
            if (isSo(v)) {
                std::size_t known = first;
                while (v < known && !first.compare_exchange_weak(known, v)) {
                }
                return;
            }
        }
    });
    return first;
}

}  // namespace

Status checkCoordinates(const MeshData& mesh, std::span<const glm::vec3> positions, const QString& path) {
    MeshExport what;
    what.mesh = &mesh;
    what.positions = positions;
    const FilePositions file(what);
    const bool isPlaced = !mesh.placement.isIdentity();
    const auto isBeyond = [&](std::size_t v) {
        return isPlaced ? !areFloats(file.now(v)) || !areFloats(file.original(v)) : !isFinite(positions[v]);
    };
    const std::size_t beyond = firstOf(positions.size(), isBeyond);
    return beyond == positions.size() ? Status(Done{}) : Status(tooFarOut(beyond, path));
}

Status checkDisplacements(const MeshExport& what, const QString& path) {
    if (Status fits = checkCoordinates(*what.mesh, what.positions, path); !fits) {
        return fits;
    }
    const Placement& placement = what.mesh->placement;
    if (placement.isIdentity()) {
        return Done{};
    }
    const FilePositions file(what);
    const auto isTooFar = [&placement](const glm::vec3& from, const glm::vec3& to) {
        return !(glm::length(glm::dvec3(to) - glm::dvec3(from)) <= kMost * placement.scale);
    };
    const std::size_t far = firstOf(what.positions.size(), [&](std::size_t v) {
        return isTooFar(what.mesh->positions[v], what.positions[v]);
    });
    if (far < what.positions.size()) {
        return tooLarge(far, " moved farther", path);
    }
    PageVector<glm::vec3> at = what.steps.empty() ? PageVector<glm::vec3>() : what.mesh->positions;
    for (const MorphStep& step : what.steps) {
        for (const MovedVertex& moved : step.moved) {
            mayGiveUp(moved.vertex);
            if (!areFloats(file.toFile(moved.position))) {
                return tooFarOut(moved.vertex, path);
            }
            if (isTooFar(at[moved.vertex], moved.position)) {
                return tooLarge(moved.vertex, " moved farther", path);
            }
            at[moved.vertex] = moved.position;
        }
    }
    return Done{};
}

}  // namespace hitscope
