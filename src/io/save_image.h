// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

#include "core/image.h"
#include "core/result.h"

namespace hitscope {

/// The picture as the bytes of a PNG file; empty if it has no pixels or the wrong number of them.
[[nodiscard]] QByteArray encodePng(const Image& image);

/// Lower-case suffixes of the pictures that can be written here, "png" first.
[[nodiscard]] QStringList pictureSuffixes();

/// Whether a picture can be written under that name; the error names the suffixes that there are.
[[nodiscard]] Status checkPictureName(const QString& path);

/// Writes a picture in the format of its suffix, whole or not at all. Errors are checkPictureName()'s, that
/// the picture is transparent and the format is not, and those of the disk.
[[nodiscard]] Status savePicture(const Image& image, const QString& path);

}  // namespace hitscope
