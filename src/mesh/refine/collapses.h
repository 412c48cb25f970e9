// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/refine/refine_work.h"

namespace hitscope {

/// A triangle that edges may be collapsed at, or what is left of it.
struct CollapsedTriangle {
    std::array<RefineCorner, 3> corners;
    std::uint32_t source = 0;  ///< face it is a part of
    std::uint32_t part = 0;    ///< borders between parts stay where they are
    bool isChanged = false;    ///< it has other corners than it had
};

/// Collapses edges at the lowest error until no more than `wanted` triangles are left or none can go.
/// `stays`: by place, those that are not moved; nor are borders. Triangles that half-edges cannot hold stay.
/// What is left comes in the order it was given.
[[nodiscard]] Result<std::vector<CollapsedTriangle>> collapse(const MeshData& mesh,
                                                              const std::vector<std::uint32_t>& places,
                                                              const std::vector<CollapsedTriangle>& triangles,
                                                              const std::vector<bool>& stays,
                                                              std::size_t wanted, const MeshGoOn& goOn);

}  // namespace hitscope
