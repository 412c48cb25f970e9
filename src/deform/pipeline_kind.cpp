// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/pipeline_kind.h"

#include <algorithm>
#include <array>

namespace hitscope {

std::span<const PipelineTraits> allPipelines() {
    static constexpr std::array<PipelineTraits, 5> kPipelines = {{
        {.kind = PipelineKind::UniformArray,
         .key = "uniform-array",
         .name = "Uniform array",
         .description = "Every vertex loops over the last hits of the scene each time it is drawn (the "
                        "paper's method 1).",
         .needs = "OpenGL 3.3",
         .keeps = "the last 600 hits of the scene, or what the driver has room for",
         .keepsAll = false,
         .isPapers = true,
         .colour = 0xe07b2a},
        {.kind = PipelineKind::UniformArrayCulled,
         .key = "uniform-array-culled",
         .name = "Uniform array, culled",
         .description =
             "Every vertex loops over the last hits that can reach its target each time it is drawn.",
         .needs = "OpenGL 3.3",
         .keeps = "the last 600 hits on each target, or what the driver has room for",
         .keepsAll = false,
         .colour = 0xb89618},
        {.kind = PipelineKind::TransformFeedback,
         .key = "transform-feedback",
         .name = "Transform feedback",
         .description = "A hit deforms the vertices near it once, in a vertex shader, and they are kept (the "
                        "paper's method 2).",
         .needs = "OpenGL 3.3",
         .keeps = "all hits",
         .isPapers = true,
         .colour = 0x3b82d6},
        {.kind = PipelineKind::Compute,
         .key = "compute",
         .name = "Compute",
         .description = "A hit deforms the vertices near it once, in a compute shader, where they lie.",
         .needs = "OpenGL 4.3",
         .keeps = "all hits",
         .needsCompute = true,
         .colour = 0x9162d4},
        {.kind = PipelineKind::Reference,
         .key = "reference",
         .name = "Reference",
         .description = "A hit deforms the vertices near it once, in C++, and what changed is uploaded.",
         .needs = "OpenGL 3.3",
         .keeps = "all hits",
         .colour = 0x7d8a97},
    }};
    return kPipelines;
}

const PipelineTraits& pipelineTraits(PipelineKind kind) {
    const std::span<const PipelineTraits> all = allPipelines();
    return *std::find_if(all.begin(), all.end(),
                         [kind](const PipelineTraits& traits) { return traits.kind == kind; });
}

std::vector<PipelineKind> pipelinesPapersFirst() {
    std::vector<PipelineKind> kinds;
    for (const PipelineTraits& traits : allPipelines()) {
        kinds.push_back(traits.kind);
    }
    std::stable_partition(kinds.begin(), kinds.end(),
                          [](PipelineKind kind) { return pipelineTraits(kind).isPapers; });
    return kinds;
}

}  // namespace hitscope
