// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "mesh/turned_normals.h"
#include "pipeline/target_buffers.h"

namespace hitscope {

/// Uploads new shading normals of these render vertices (sorted) in runs.
void writeShadingNormals(TargetBuffers& buffers, std::span<const std::uint32_t> vertices,
                         const TurnedNormals& normals);

}  // namespace hitscope
