// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/mesh_data.h"

namespace hitscope {

/// Names of a material's pictures; empty: none.
struct PlacedTextures {
    std::string diffuse;         ///< on the map_Kd line
    std::string normals;         ///< on the norm or map_Bump line
    std::string metalRoughness;  ///< on the map_Pr and map_Pm lines
};

/// The MTL text of a mesh's materials, under the names that formatObj() uses. textures: one a material.
[[nodiscard]] std::string formatMtl(const MeshData& mesh, const std::vector<PlacedTextures>& textures);

}  // namespace hitscope
