// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/mesh_data.h"

namespace hitscope {

/// What a mesh's materials call the pictures that were not found or could not be read; each once, in the
/// materials' order.
[[nodiscard]] std::vector<std::string> missingTextures(const MeshData& mesh);

/// The mesh with that picture wherever its materials miss `name`.
[[nodiscard]] MeshData withTexture(MeshData mesh, const std::string& name, Image image);

}  // namespace hitscope
