// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "mesh/mesh_data.h"

namespace hitscope {

/// By file vertex: a face uses it.
[[nodiscard]] std::vector<bool> usedVertices(const MeshData& mesh);

/// For each file vertex, the one that stands for its place: the lowest of those that faces use and whose
/// positions are equal; itself where no face uses it. V entries.
[[nodiscard]] std::vector<std::uint32_t> weldedVertices(const MeshData& mesh);
/// `used` says of each vertex whether a face uses it.
[[nodiscard]] std::vector<std::uint32_t> weldedVertices(std::span<const glm::vec3> positions,
                                                        const std::vector<bool>& used);

}  // namespace hitscope
