// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "mesh/render_mesh.h"

namespace hitscope {

/// How vertices differ from what they should be, in any bit of position or normal.
struct VertexDifference {
    std::size_t vertices = 0;   ///< compared
    std::size_t different = 0;  ///< of these
    float largest = 0.0f;       ///< metres between two positions; infinite for a NaN

    bool operator==(const VertexDifference&) const = default;

    /// Compares as many more, bit for bit: the signs of zero count. Both are equally long.
    void add(std::span<const DynamicVertex> actual, std::span<const DynamicVertex> expected);
};

/// "12 of 4,096 vertices differ, by up to 0.1 m".
[[nodiscard]] std::string describe(const VertexDifference& difference);

}  // namespace hitscope
