// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFileDevice>
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
/// The same to a file that is open.
[[nodiscard]] Status writeMeshStream(const MeshData& mesh, QFileDevice& file);

/// Reads it back, as untrusted input: every length is checked against the bytes left before anything is
/// allocated, what is allocated comes to at most `memoryBytes`, the mesh has passed validate(), and what is
/// drawn of it are numbers in their ranges. `cancelled` (may be null) is looked at between arrays and within
/// them. A pipe or a device at `path` is refused.
[[nodiscard]] Result<MeshData> readMeshStream(const QString& path, const ProgressSink& progress = {},
                                              const std::atomic_bool* cancelled = nullptr,
                                              std::uint64_t memoryBytes = UINT64_MAX);
/// The same from a device that is open, and not sequential.
[[nodiscard]] Result<MeshData> readMeshStream(QIODevice& device, const ProgressSink& progress = {},
                                              const std::atomic_bool* cancelled = nullptr,
                                              std::uint64_t memoryBytes = UINT64_MAX);

}  // namespace hitscope
