// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/frame_rate/pipeline_colour.h"

namespace hitscope {

QColor pipelineColour(PipelineKind pipeline) {
    return QColor::fromRgb(pipelineTraits(pipeline).colour);
}

}  // namespace hitscope
