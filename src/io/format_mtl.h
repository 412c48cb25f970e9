// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/mesh_data.h"

namespace hitscope {

/// The MTL text of a mesh's materials, under the names that formatObj() uses. textures: for each material the
/// name to write on its map_Kd line, or empty for none.
[[nodiscard]] std::string formatMtl(const MeshData& mesh, const std::vector<std::string>& textures);

}  // namespace hitscope
