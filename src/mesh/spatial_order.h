// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "mesh/render_mesh.h"

namespace hitscope {

/// An order of points in which neighbours in space are neighbours in the order.
struct SpatialOrder {
    std::vector<std::uint32_t> order;  ///< order[i]: the point that comes i-th
    std::vector<Cluster> clusters;     ///< runs of it of at most kClusterVertices; cover it
};

/// Halves the points on their longest axis again and again. O(n log n) for n points.
[[nodiscard]] SpatialOrder spatialOrder(std::span<const glm::vec3> points);

}  // namespace hitscope
