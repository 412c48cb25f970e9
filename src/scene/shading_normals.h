// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "pipeline/target_buffers.h"

namespace hitscope {

/// Uploads new shading normals of these render vertices (sorted) in runs; `normals`: one a render vertex.
void writeShadingNormals(TargetBuffers& buffers, std::span<const std::uint32_t> vertices,
                         std::span<const glm::vec3> normals);

}  // namespace hitscope
