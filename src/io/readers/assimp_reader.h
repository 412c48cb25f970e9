// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string_view>

#include "core/result.h"
#include "io/imported_mesh.h"

namespace hitscope {

/// Reads a glTF, GLB, FBX, 3DS or DAE file with Assimp, without any of its post-processing: polygons and
/// the file's vertices stay. The scene's meshes become one, each instance moved by its node and named as an
/// object. Formats whose readers give each face vertices of its own (FBX, 3DS, DAE) get them shared where
/// their positions are equal. Animations and skins are left out, with a note.
///
/// `content` is the file's: what would make very much of little is refused by a look at it. Assimp crashes,
/// hangs and aborts on broken files all the same: only ever called in the import worker.
[[nodiscard]] Result<ImportedMesh> readWithAssimp(const QString& path, std::string_view content,
                                                  const ProgressSink& progress);

}  // namespace hitscope
