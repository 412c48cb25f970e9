// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/result.h"
#include "render/display_options.h"
#include "session/target.h"

namespace hitscope {

/// Writes a target as it is on the screen to an OBJ file, in its file's own vertex order, with true or the
/// paper's normals. The target's read-back is current. Errors are exportObj()'s.
[[nodiscard]] Status exportTarget(const Target& target, const QString& path, NormalMode normals);

}  // namespace hitscope
