// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace hitscope {

// What a file may make of the meshes it places: what is more does not fit into the memory that the worker may
// take, so it is refused before any of it is made.
inline constexpr std::uint64_t kMostVertices = 50'000'000;
inline constexpr std::uint64_t kMostCorners = 200'000'000;
inline constexpr std::uint64_t kMostInstances = 1'000'000;

}  // namespace hitscope
