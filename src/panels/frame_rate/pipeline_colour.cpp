// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/frame_rate/pipeline_colour.h"

namespace hitscope {

QColor pipelineColour(PipelineKind pipeline) {
    switch (pipeline) {
        case PipelineKind::UniformArray:
            return {0xe0, 0x7b, 0x2a};
        case PipelineKind::UniformArrayCulled:
            return {0xb8, 0x96, 0x18};
        case PipelineKind::TransformFeedback:
            return {0x3b, 0x82, 0xd6};
        case PipelineKind::Compute:
            return {0x91, 0x62, 0xd4};
        case PipelineKind::Reference:
            return {0x7d, 0x8a, 0x97};
    }
    return {};
}

}  // namespace hitscope
