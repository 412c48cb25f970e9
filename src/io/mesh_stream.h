// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <atomic>
#include <cstdint>

#include "core/result.h"
#include "io/imported_mesh.h"

namespace hitscope {

/// Another one with every change of what is written.
inline constexpr std::uint32_t kMeshStreamVersion = 5;

/// Writes a mesh in Hitscope's own short-lived form, which carries it from the import worker to the program.
[[nodiscard]] Status writeMeshStream(const MeshData& mesh, const QString& path);

/// Reads it back, as untrusted input: every length is checked against the bytes left before anything is
/// allocated, and the mesh has passed validate(). `cancelled` (may be null) is looked at between arrays.
[[nodiscard]] Result<MeshData> readMeshStream(const QString& path, const ProgressSink& progress = {},
                                              const std::atomic_bool* cancelled = nullptr);

}  // namespace hitscope
