// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/result.h"
#include "mesh/mesh_data.h"
#include "session/session.h"

namespace hitscope::cli {

/// A target as it was at one moment, apart from its session.
struct TargetShape {
    QString name;
    std::shared_ptr<const MeshData> mesh;
    std::vector<glm::vec3> positions;  ///< one a file vertex, local frame, metres
};
[[nodiscard]] std::vector<TargetShape> shapesOf(const Session& session);

/// Where a vertex is in the coordinates of the mesh's file.
[[nodiscard]] glm::dvec3 inFile(const TargetShape& shape, std::size_t vertex);

/// How far apart the vertices of two targets are, in the coordinates of their files; metres.
struct ShapeDifference {
    std::size_t vertices = 0;
    std::size_t different = 0;  ///< in any bit; of numbers in the file where the two were placed differently
    double largest = 0.0;       ///< infinite where one is not finite
    std::uint32_t vertex = 0;   ///< of the file, where that is
    double rootMeanSquare = 0.0;  ///< over all vertices
};
/// An error where the two are not of the same topology.
[[nodiscard]] Result<ShapeDifference> differenceOf(const TargetShape& a, const TargetShape& b);

}  // namespace hitscope::cli
