// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/result.h"
#include "io/imported_mesh.h"

namespace hitscope {

/// Reads a mesh file of any known format with its materials and textures; the suffix decides. The mesh has at
/// least one face and has passed validate(). May throw std::bad_alloc, and (Assimp) end the process: for the
/// import worker.
[[nodiscard]] Result<ImportedMesh> readMesh(const QString& path, const ProgressSink& progress);

}  // namespace hitscope
