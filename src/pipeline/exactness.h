// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/result.h"
#include "pipeline/vertex_difference.h"

namespace hitscope {

/// Whether this renderer's vertex shaders deform as deform() in C++ does, in every bit. The function jumps by
/// 0.1 m at its rim, so that a division or square root that is one unit in the last place off can show. It
/// decides which variant of the function the pipelines are built with; whether they are right with it is
/// tried end to end (tryPipeline()).
struct Exactness {
    VertexDifference compared;
    bool byFma = false;  ///< with both corrected by fma; no renderer at hand needs it and has a fused one

    [[nodiscard]] bool isExact() const { return compared.different == 0; }
    bool operator==(const Exactness&) const = default;

    /// For every program that includes deform.glsl, as gl::Defines: the variant that was measured.
    [[nodiscard]] std::vector<std::pair<std::string, std::string>> defines() const;
};

/// Deforms some thousand vertices, many of them within a few units in the last place of the rim, through a
/// vertex shader with transform feedback and by deform(), and compares. First with the renderer's own
/// division and square root; if they are not exact, corrected by fma; the result is of the variant that is
/// exact, else of the renderer's own. Only vertex shaders are measured: fragment and compute shaders are
/// taken to calculate alike. `defines` are added to the programs. A context is current; its state is left as
/// it was. The error is the driver's, when it does not accept the shader.
[[nodiscard]] Result<Exactness> measureExactness(
    const std::vector<std::pair<std::string, std::string>>& defines = {});

/// "bit-exact in 8,192 vertices compared".
/// "not bit-exact: 12 of 4,096 vertices differ, by up to 0.1 m".
[[nodiscard]] std::string describe(const Exactness& exactness);

}  // namespace hitscope
