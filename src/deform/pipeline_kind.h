// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace hitscope {

enum class PipelineKind : std::uint8_t {
    UniformArray,
    UniformArrayCulled,
    TransformFeedback,
    Compute,
    Reference
};

/// What people are told about a pipeline.
struct PipelineTraits {
    PipelineKind kind = PipelineKind::TransformFeedback;
    std::string_view key;          ///< as on the command line: "uniform-array"
    std::string_view name;         ///< as in the interface: "Uniform array"
    std::string_view description;  ///< one sentence
    std::string_view needs;        ///< "OpenGL 3.3"
    std::string_view keeps;        ///< "the last 600 hits of the scene"
    bool keepsAll = true;          ///< any number of hits, in the vertices: applying many takes a while
    bool needsCompute = false;     ///< compute shaders
    bool isPapers = false;         ///< one of the paper's two methods
    std::uint32_t colour = 0;      ///< 0xrrggbb in plots, told apart on light and on dark
};
/// Every pipeline there is, in the order the interface lists them.
[[nodiscard]] std::span<const PipelineTraits> allPipelines();
[[nodiscard]] const PipelineTraits& pipelineTraits(PipelineKind kind);
/// All of them as well, the paper's methods first: costs are compared with theirs.
[[nodiscard]] std::vector<PipelineKind> pipelinesPapersFirst();

}  // namespace hitscope
