// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/writers/mesh_export.h"

namespace hitscope {

// A mesh near the largest float is shown at another size and can be dented there to where its file has no
// numbers: such an export is refused, as the file would hold "inf" and no program would open it.

/// That floats hold where the vertices are in the mesh's file, `positions` (one a vertex, local frame,
/// metres) and the original's. The error names the first vertex beyond.
[[nodiscard]] Status checkCoordinates(const MeshData& mesh, std::span<const glm::vec3> positions,
                                      const QString& path);

/// That, and how far vertices moved, of all steps too: for formats that hold displacements.
[[nodiscard]] Status checkDisplacements(const MeshExport& what, const QString& path);

}  // namespace hitscope
