// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "deform/vertex_difference.h"

namespace hitscope {

/// Whether this renderer's vertex shaders deform as deform() in C++ does, in every bit. The function jumps by
/// 0.1 m at its rim, so that a division or square root that is one unit in the last place off can show. It
/// decides which variant of the function the pipelines are built with; whether they are right with it is
/// tried end to end (PipelineVerdict).
struct Exactness {
    VertexDifference compared;
    bool byFma = false;  ///< with both corrected by fma, which NVIDIA's driver needs

    [[nodiscard]] bool isExact() const { return compared.different == 0; }
    bool operator==(const Exactness&) const = default;
};

/// "bit-exact in 8,192 vertices compared".
/// "not bit-exact: 12 of 4,096 vertices differ, by up to 0.1 m".
[[nodiscard]] std::string describe(const Exactness& exactness);

}  // namespace hitscope
