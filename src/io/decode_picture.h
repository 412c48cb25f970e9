// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QImage>
#include <QString>

#include "core/image.h"

namespace hitscope {

/// A picture that can be a texture, by its content: PNG, JPEG, TGA, TIFF, WebP, BMP, GIF, PPM or PGM of up to
/// 8192 pixels a side. Vector formats, which could name further files, are none. Null: `why` says why, as the
/// end of a sentence.
[[nodiscard]] QImage decodePicture(const QByteArray& bytes, QString& why);

[[nodiscard]] Image imageOf(const QImage& picture);

}  // namespace hitscope
