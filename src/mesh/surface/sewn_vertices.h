// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace hitscope {

/// For each file vertex, the one that stands for it where a surface that its file split is put together
/// again: across edges at one place at which two triangles end, but not more. The two sides of a thin wall,
/// which lie in one place, stay apart so. The lowest of each; V entries, or none where nothing is split.
/// `triangles` (three indices each) are of the file's vertices, `positions` the original ones.
[[nodiscard]] std::vector<std::uint32_t> sewnVertices(std::span<const glm::vec3> positions,
                                                      std::span<const std::uint32_t> triangles);

}  // namespace hitscope
