// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "mesh/mesh_data.h"

namespace hitscope {

/// An error where a face or line of a PLY file refers to none of its vertices.
[[nodiscard]] Status checkPlyIndices(const MeshData& mesh, std::size_t vertices);

}  // namespace hitscope
