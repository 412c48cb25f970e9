// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mesh/mesh_data.h"

namespace hitscope {

/// A name as it can stand on a line of OBJ or MTL: control characters become blanks, none at the ends.
[[nodiscard]] std::string nameOnLine(std::string_view name);

/// A name for each material: never empty and no two alike, since OBJ refers to materials by name. Names that
/// are fine already stay as they are.
[[nodiscard]] std::vector<std::string> materialNames(const MeshData& mesh);

}  // namespace hitscope
