// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "io/check/written_check.h"

namespace hitscope {

/// What a format makes of normals, texture coordinates and materials.
enum class SurfaceFormat : std::uint8_t { Obj, Ply };

/// Holds normals, texture coordinates and materials that were read back against what was meant, as far as the
/// format holds them; both have the same vertices and faces. Gives the first difference in words. `normals`
/// as written; empty: none were given to the writer. normalsAreExact: the file's type holds floats.
[[nodiscard]] std::optional<std::string> surfaceDifference(const MeshData& read, const MeshExport& what,
                                                           const WrittenNormals& normals,
                                                           SurfaceFormat format, bool normalsAreExact,
                                                           const ExportGoOn& goOn);

/// "corner 2 of face 7"
[[nodiscard]] std::string cornerName(std::size_t face, std::size_t corner);
/// "corner 2 of face 7 has the normal 0 0 1 and should have 0 1 0"; components: 2 or 3.
[[nodiscard]] std::string otherVector(const std::string& which, const char* kind, const glm::vec3& is,
                                      const glm::vec3& meant, int components);

}  // namespace hitscope
