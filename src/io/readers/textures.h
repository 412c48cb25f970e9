// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <optional>

#include "io/imported_mesh.h"

namespace hitscope {

/// Decodes a picture of a common format (told by its content). Nothing, and the reason in `why`, when it is
/// not one, or is larger than 8192 x 8192.
[[nodiscard]] std::optional<Image> decodeImage(const QByteArray& bytes, QString& why);

/// Decodes the textures that materials name and that have no image yet; each file once. Only files in
/// `folder` (and below) are opened; a texture named elsewhere is taken from `folder` if a file of that name
/// is there. Trouble is a note. Notes in pictureFiles which of them are pictures, and which of `others`: maps
/// that are not drawn. Textures that only opaque materials have become opaque.
void readTextures(ImportedMesh& imported, const QString& folder, const QStringList& others = {});

}  // namespace hitscope
