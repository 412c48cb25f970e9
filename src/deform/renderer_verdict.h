// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>

#include "deform/pipeline_kind.h"
#include "deform/vertex_difference.h"

namespace hitscope {

/// Whether a pipeline, run on this renderer from hits to read-back, makes what the reference makes
/// (tryPipeline()).
struct PipelineVerdict {
    VertexDifference compared;
    std::string whyNot;  ///< it did not run: why; empty: it did

    [[nodiscard]] bool isExact() const { return whyNot.empty() && compared.different == 0; }
    bool operator==(const PipelineVerdict&) const = default;
};

/// Whether what is said to lie under a pixel is what a ray on the CPU meets there (tryPicking()).
struct PickingVerdict {
    std::size_t pixels = 0;   ///< compared
    std::size_t wrong = 0;    ///< of these
    bool byGeometry = false;  ///< only with a geometry shader that hands on the numbers of primitives
    std::string whyNot;       ///< the driver does not take the programs: why; empty: it does

    [[nodiscard]] bool isRight() const { return whyNot.empty() && wrong == 0; }
    bool operator==(const PickingVerdict&) const = default;
};

/// What has been found out so far about the renderer that draws.
struct RendererVerdict {
    std::map<PipelineKind, PipelineVerdict> pipelines;
    std::optional<PickingVerdict> picking;

    bool operator==(const RendererVerdict&) const = default;

    /// Nothing: not tried yet.
    [[nodiscard]] const PipelineVerdict* of(PipelineKind kind) const;
    /// What to use where `kind` failed and nobody asked for it: the first one of allPipelines() that keeps
    /// all hits and is exact. Nothing: it did not fail, or no other is known to be exact.
    [[nodiscard]] std::optional<PipelineKind> insteadOf(PipelineKind kind) const;
};

/// "bit-exact in 15,462 vertices compared".
/// "not bit-exact: 12 of 15,462 vertices differ, by up to 0.1 m".
/// "not compared: Compute shaders need OpenGL 4.3 ..."
[[nodiscard]] std::string describe(const PipelineVerdict& verdict);
/// "right in 4,096 pixels compared", "wrong in 12 of 4,096 pixels compared".
[[nodiscard]] std::string describe(const PickingVerdict& verdict);
/// "Transform feedback: bit-exact in 15,462 vertices compared"; "...: not compared yet".
[[nodiscard]] std::string describe(const RendererVerdict& verdict, PipelineKind kind);

}  // namespace hitscope
