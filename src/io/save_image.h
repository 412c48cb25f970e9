// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

#include "core/image.h"
#include "core/result.h"

namespace hitscope {

/// The picture as the bytes of a PNG file; empty if it has no pixels or the wrong number of them.
[[nodiscard]] QByteArray encodePng(const Image& image);

/// Writes a PNG, whole or not at all.
[[nodiscard]] Status savePng(const Image& image, const QString& path);

}  // namespace hitscope
