// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "mesh/render_mesh.h"

namespace hitscope {

/// An order of points in which neighbours in space are neighbours in the order, above all those of each run
/// of kClusterVertices. order[i]: the point that comes i-th. Halves the points on their longest axis again
/// and again: O(n log n) for n points.
[[nodiscard]] std::vector<std::uint32_t> spatialOrder(std::span<const glm::vec3> points);

}  // namespace hitscope
