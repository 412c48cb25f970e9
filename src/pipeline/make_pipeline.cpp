// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/compute_pipeline.h"
#include "pipeline/deformation_pipeline.h"
#include "pipeline/reference_pipeline.h"
#include "pipeline/transform_feedback_pipeline.h"
#include "pipeline/uniform_array_pipeline.h"

namespace hitscope {

namespace {

/// epoxy's way to say 4.3.
constexpr int kComputeVersion = 43;

}  // namespace

std::optional<std::string> whyUnavailable(PipelineKind kind) {
    const int version = epoxy_gl_version();
    if (!pipelineTraits(kind).needsCompute || version >= kComputeVersion) {
        return std::nullopt;
    }
    return "Compute shaders need OpenGL 4.3; this graphics driver offers OpenGL " +
           std::to_string(version / 10) + "." + std::to_string(version % 10) + ".";
}

Result<std::unique_ptr<DeformationPipeline>> makePipeline(PipelineKind kind, const PipelineOptions& options) {
    if (const std::optional<std::string> reason = whyUnavailable(kind)) {
        return Error{*reason, {}, "Choose another pipeline; all end at the same mesh."};
    }
    switch (kind) {
        case PipelineKind::UniformArray:
        case PipelineKind::UniformArrayCulled:
            return UniformArrayPipeline::create(kind, options);
        case PipelineKind::TransformFeedback:
            return TransformFeedbackPipeline::create(options);
        case PipelineKind::Compute:
            return ComputePipeline::create(options);
        case PipelineKind::Reference:
            return std::unique_ptr<DeformationPipeline>(std::make_unique<ReferencePipeline>());
    }
    return Error{"There is no such pipeline.", {}, {}};
}

}  // namespace hitscope
