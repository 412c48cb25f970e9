// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "pipeline/deformation_pipeline.h"
#include "pipeline/hit_arrays.h"

namespace hitscope {

/// Where to try to keep hits, the best first: OpenGL leaves it to the driver how densely arrays are packed. A
/// context is current.
[[nodiscard]] std::vector<HitRoom> roomsToTry(const PipelineOptions& options);
/// Likewise, with room for forms.
[[nodiscard]] std::vector<HitRoom> formRoomsToTry(const PipelineOptions& options);

}  // namespace hitscope
