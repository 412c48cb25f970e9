// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/image.h"
#include "core/result.h"

namespace hitscope {

/// A picture that a person chose as a texture, as decodePicture() takes them. The error says why it cannot be
/// one.
[[nodiscard]] Result<Image> readPicture(const QString& path);

}  // namespace hitscope
