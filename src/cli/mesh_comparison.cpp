// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh_comparison.h"

#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace hitscope::cli {

namespace {

bool sameBits(const glm::vec3& a, const glm::vec3& b) {
    const auto same = [](float x, float y) {
        return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
    };
    return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}

}  // namespace

std::vector<TargetShape> shapesOf(const Session& session) {
    std::vector<TargetShape> shapes;
    for (const std::unique_ptr<Target>& target : session.targets()) {
        const std::span<const glm::vec3> positions = target->deformed.positions();
        shapes.push_back(
            {target->name, target->deformed.sharedOriginal(), {positions.begin(), positions.end()}});
    }
    return shapes;
}

Result<ShapeDifference> differenceOf(const TargetShape& a, const TargetShape& b) {
    if (a.positions.size() != b.positions.size() || a.mesh->faceStarts != b.mesh->faceStarts ||
        a.mesh->cornerVertices != b.mesh->cornerVertices) {
        return Error{"The meshes are not of the same topology: " + std::to_string(a.positions.size()) +
                         " vertices and " + std::to_string(a.mesh->faceCount()) + " faces, and " +
                         std::to_string(b.positions.size()) + " and " + std::to_string(b.mesh->faceCount()) +
                         ".",
                     a.name.toStdString() + ", " + b.name.toStdString(),
                     "Compare meshes that have the same vertices and faces in the same order."};
    }
    ShapeDifference difference;
    difference.vertices = a.positions.size();
    double squares = 0.0;
    for (std::size_t v = 0; v < a.positions.size(); ++v) {
        if (sameBits(a.positions[v], b.positions[v])) {
            continue;
        }
        ++difference.different;
        double distance = glm::distance(glm::dvec3(a.positions[v]), glm::dvec3(b.positions[v]));
        if (!std::isfinite(distance)) {
            distance = std::numeric_limits<double>::infinity();
        }
        squares += distance * distance;
        if (difference.different == 1 || distance > difference.largest) {
            difference.largest = distance;
            difference.vertex = static_cast<std::uint32_t>(v);
        }
    }
    difference.rootMeanSquare =
        difference.vertices > 0 ? std::sqrt(squares / static_cast<double>(difference.vertices)) : 0.0;
    return difference;
}

}  // namespace hitscope::cli
