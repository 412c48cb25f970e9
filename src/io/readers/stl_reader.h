// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/result.h"
#include "io/imported_mesh.h"

namespace hitscope {

/// Parses an STL file's bytes, binary or ascii; pure. STL repeats its vertices: equal positions become one,
/// in the order of first appearance. The facets' normals follow from the vertices and are not read.
[[nodiscard]] Result<ImportedMesh> parseStl(std::string_view file, const ProgressSink& progress = {});

}  // namespace hitscope
