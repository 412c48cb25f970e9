// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "deform/renderer_verdict.h"
#include "pipeline/deformation_pipeline.h"

namespace hitscope {

/// Runs the real pipeline, buffers and read-back on two small targets, one of them of more vertices than some
/// drivers count well in one draw: dozens of overlapping hits, many with a vertex at the rim; one at a time,
/// in batches, taken out of the middle, put back, changed; at first with the paper's function, then of all
/// forms. Holds positions and normals against the reference, bit for bit, four times on the way. Begins at
/// the end of the buffers that hits are handed over in. `options` as the session's own pipeline has them. A
/// context is current; its state is left as it was. Some ten milliseconds on a software renderer that
/// compiles shaders.
[[nodiscard]] PipelineVerdict tryPipeline(PipelineKind kind, const PipelineOptions& options = {});

}  // namespace hitscope
