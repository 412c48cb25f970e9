// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSurfaceFormat>

namespace hitscope {

/// What the viewport draws into: OpenGL 3.3 core, 24-bit depth, and 4x multisampling where a GPU does it. A
/// software renderer pays for every sample, so it gets one. Needs a QGuiApplication; asks the driver once.
[[nodiscard]] QSurfaceFormat viewportFormat();

}  // namespace hitscope
