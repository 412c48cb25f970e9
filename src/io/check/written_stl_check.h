// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/result.h"
#include "io/writers/mesh_export.h"

namespace hitscope {

/// The part of verifyWritten() for STL: holds triangles that were read back, and the facets' normals, which
/// opening the file leaves out, against what was meant.
[[nodiscard]] Status verifyWrittenStl(const MeshData& read, const MeshExport& what, const QString& path,
                                      const ExportGoOn& goOn);

}  // namespace hitscope
