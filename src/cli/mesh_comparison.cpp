// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh_comparison.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "io/writers/file_coordinate.h"

namespace hitscope::cli {

namespace {

bool sameBits(const glm::vec3& a, const glm::vec3& b) {
    const auto same = [](float x, float y) {
        return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
    };
    return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}

/// In floats where both are in one frame, which tells all bits apart.
class Pair {
public:
    Pair(const TargetShape& a, const TargetShape& b)
        : m_a(a), m_b(b), m_isOneFrame(a.mesh->placement == b.mesh->placement) {}

    [[nodiscard]] bool isSame(std::size_t vertex) const {
        return m_isOneFrame ? sameBits(m_a.positions[vertex], m_b.positions[vertex])
                            : inFile(m_a, vertex) == inFile(m_b, vertex);
    }
    [[nodiscard]] double distance(std::size_t vertex) const {
        return m_isOneFrame
                   ? glm::distance(glm::dvec3(m_a.positions[vertex]), glm::dvec3(m_b.positions[vertex])) /
                         m_a.mesh->placement.scale
                   : glm::distance(inFile(m_a, vertex), inFile(m_b, vertex));
    }

private:
    const TargetShape& m_a;
    const TargetShape& m_b;
    bool m_isOneFrame;
};

/// The first face, from 1, that has other vertices, or has them in another order; both have as many.
std::size_t firstOtherFace(const MeshData& a, const MeshData& b) {
    std::size_t f = 0;
    while (f < a.faceCount() && std::ranges::equal(a.face(f), b.face(f))) {
        ++f;
    }
    return f + 1;
}

Error otherTopology(const TargetShape& a, const TargetShape& b) {
    const auto counts = [](const TargetShape& shape) {
        return std::to_string(shape.positions.size()) + " vertices and " +
               std::to_string(shape.mesh->faceCount()) + " faces";
    };
    const bool isAsMany =
        a.positions.size() == b.positions.size() && a.mesh->faceCount() == b.mesh->faceCount();
    return {isAsMany ? "The meshes are not of the same topology: face " +
                           std::to_string(firstOtherFace(*a.mesh, *b.mesh)) +
                           " has other vertices, or begins with another one."
                     : "The meshes are not of the same topology: one has " + counts(a) + ", the other " +
                           counts(b) + ".",
            a.name.toStdString() + ", " + b.name.toStdString(),
            "Compare meshes that have the same vertices and faces in the same order."};
}

}  // namespace

glm::dvec3 inFile(const TargetShape& shape, std::size_t vertex) {
    const glm::vec3& now = shape.positions[vertex];
    return {fileCoordinate(*shape.mesh, vertex, now, 0), fileCoordinate(*shape.mesh, vertex, now, 1),
            fileCoordinate(*shape.mesh, vertex, now, 2)};
}

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
        return otherTopology(a, b);
    }
    const Pair pair(a, b);
    ShapeDifference difference;
    difference.vertices = a.positions.size();
    double squares = 0.0;
    for (std::size_t v = 0; v < a.positions.size(); ++v) {
        if (pair.isSame(v)) {
            continue;
        }
        ++difference.different;
        double distance = pair.distance(v);
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
