// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/pipeline_kind.h"

#include <algorithm>
#include <array>

namespace hitscope {

std::span<const PipelineTraits> allPipelines() {
    static constexpr std::array<PipelineTraits, 2> kPipelines = {{
        {PipelineKind::UniformArray, "uniform-array", "Uniform array",
         "Every vertex loops over the last hits each time it is drawn (the paper's method 1)."},
        {PipelineKind::TransformFeedback, "transform-feedback", "Transform feedback",
         "A hit deforms the vertices near it once and keeps them, however many hits there are (the paper's "
         "method 2)."},
    }};
    return kPipelines;
}

const PipelineTraits& pipelineTraits(PipelineKind kind) {
    const std::span<const PipelineTraits> all = allPipelines();
    return *std::find_if(all.begin(), all.end(),
                         [kind](const PipelineTraits& traits) { return traits.kind == kind; });
}

}  // namespace hitscope
