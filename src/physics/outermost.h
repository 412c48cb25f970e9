// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "physics/triangle_tree.h"

namespace hitscope::physics {

/// The outermost vertices in some dozens of directions, each once: a hull that is good enough to tumble on.
/// `tree` is that of the triangles `corners` (3 each) at `vertices`. Its boxes lead to them: a fine mesh is
/// not gone through.
[[nodiscard]] std::vector<glm::vec3> outermost(const TriangleTree& tree, std::span<const glm::vec3> vertices,
                                               std::span<const std::uint32_t> corners);

}  // namespace hitscope::physics
