// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/image.h"
#include "core/result.h"

namespace hitscope {

/// Writes a PNG, whole or not at all.
[[nodiscard]] Status savePng(const Image& image, const QString& path);

}  // namespace hitscope
