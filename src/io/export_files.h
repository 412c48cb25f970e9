// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "io/format_mtl.h"
#include "mesh/mesh_data.h"

namespace hitscope {

/// Writes a file, whole or not at all.
[[nodiscard]] Status writeWhole(const QString& path, std::string_view content);

/// A path in `folder` for a file of that name and content: `name` if it is free or already has this content,
/// else "base-1.suffix", "base-2.suffix" ... What is there is never to be overwritten.
[[nodiscard]] QString freePath(const QString& folder, const QString& name, const QByteArray& content);

/// Sees to it that the textures of the mesh's materials lie in `folder` or below: copies them from
/// `sourceFolder`, and writes those that have no file as PNG (named after `baseName`). Gives for each
/// material the names to refer to; textures that cannot be found keep theirs.
[[nodiscard]] Result<std::vector<PlacedTextures>> placeTextures(const MeshData& mesh,
                                                                const QString& sourceFolder,
                                                                const QString& folder,
                                                                const QString& baseName);

}  // namespace hitscope
