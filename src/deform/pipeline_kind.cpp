// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/pipeline_kind.h"

#include <algorithm>
#include <array>

namespace hitscope {

std::span<const PipelineTraits> allPipelines() {
    static constexpr std::array<PipelineTraits, 5> kPipelines = {{
        {PipelineKind::UniformArray, "uniform-array", "Uniform array",
         "Every vertex loops over the last hits of the scene each time it is drawn (the paper's method 1).",
         "OpenGL 3.3", "the last 600 hits of the scene, or what the driver has room for", false},
        {PipelineKind::UniformArrayCulled, "uniform-array-culled", "Uniform array, culled",
         "Every vertex loops over the last hits that can reach its target each time it is drawn.",
         "OpenGL 3.3", "the last 600 hits on each target, or what the driver has room for", false},
        {PipelineKind::TransformFeedback, "transform-feedback", "Transform feedback",
         "A hit deforms the vertices near it once, in a vertex shader, and they are kept (the paper's "
         "method 2).",
         "OpenGL 3.3", "all hits"},
        {PipelineKind::Compute, "compute", "Compute",
         "A hit deforms the vertices near it once, in a compute shader, where they lie.", "OpenGL 4.3",
         "all hits"},
        {PipelineKind::Reference, "reference", "Reference",
         "A hit deforms the vertices near it once, in C++, and what changed is uploaded.", "OpenGL 3.3",
         "all hits"},
    }};
    return kPipelines;
}

const PipelineTraits& pipelineTraits(PipelineKind kind) {
    const std::span<const PipelineTraits> all = allPipelines();
    return *std::find_if(all.begin(), all.end(),
                         [kind](const PipelineTraits& traits) { return traits.kind == kind; });
}

}  // namespace hitscope
