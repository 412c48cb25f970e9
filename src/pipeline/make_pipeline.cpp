// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/deformation_pipeline.h"
#include "pipeline/transform_feedback_pipeline.h"
#include "pipeline/uniform_array_pipeline.h"

namespace hitscope {

Result<std::unique_ptr<DeformationPipeline>> makePipeline(PipelineKind kind, const PipelineLimits& limits) {
    switch (kind) {
        case PipelineKind::UniformArray:
            return UniformArrayPipeline::create(limits);
        case PipelineKind::TransformFeedback:
            return TransformFeedbackPipeline::create();
    }
    return Error{"There is no such pipeline.", {}, {}};
}

}  // namespace hitscope
