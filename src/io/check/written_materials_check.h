// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <string>

#include "io/writers/mesh_export.h"

namespace hitscope {

/// Holds the materials of an OBJ that was read back against what was meant; both have the same faces, with
/// materials of the same names. MTL files that were copied have every line of their source, but for names of
/// pictures; materials that were written anew have their numbers, as far as an MTL holds them. A picture that
/// the mesh shows is there, and the same. Gives the first difference in words.
[[nodiscard]] std::optional<std::string> materialDifference(const MeshData& read, const MeshExport& what,
                                                            const QString& path);

/// The picture that a PLY names in its header: the same, or of the same name where it is not shown.
[[nodiscard]] std::optional<std::string> textureDifference(const MeshData& read, const MeshExport& what,
                                                           const QString& path);

}  // namespace hitscope
