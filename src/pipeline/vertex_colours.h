// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace hitscope {

/// Linear red, green and blue, 65535 for 1; the last number fills up to what GPUs read at once.
using LinearColour = std::array<std::uint16_t, 4>;

/// One colour a render vertex. srgb: one a file vertex, [0, 1]; fileVertices: RenderMesh's, all <
/// srgb.size().
[[nodiscard]] std::vector<LinearColour> linearColours(std::span<const glm::vec3> srgb,
                                                      std::span<const std::uint32_t> fileVertices);

}  // namespace hitscope
