// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/result.h"
#include "io/imported_mesh.h"

namespace hitscope {

/// Parses a PLY file's bytes (ascii, binary of either byte order); pure. Reads vertices (x y z, nx ny nz,
/// s t / u v / texture_u texture_v, red green blue) of any numeric type, faces (vertex_indices or
/// vertex_index, and MeshLab's texcoord list), and triangle strips; everything else is skipped. Memory
/// follows the file's size, whatever its header says.
[[nodiscard]] Result<ImportedMesh> parsePly(std::string_view file, const ProgressSink& progress = {});

}  // namespace hitscope
