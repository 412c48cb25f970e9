// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSurfaceFormat>

#include "core/result.h"

namespace hitscope {

/// OpenGL 3.3 core, 24-bit depth: what every context of the window is at least.
[[nodiscard]] QSurfaceFormat baseSurfaceFormat();

/// What the viewport draws into: OpenGL 3.3 core, 24-bit depth, and 4x multisampling where a GPU does it. A
/// software renderer pays for every sample, so it gets one. Needs a QGuiApplication; asks the driver once.
[[nodiscard]] QSurfaceFormat viewportFormat();

/// Whether there is such OpenGL here at all. Ask before making a Viewport: where there is none, Qt's OpenGL
/// widgets end the process. Needs a QGuiApplication; asks the driver once.
[[nodiscard]] Status checkOpenGl();

}  // namespace hitscope
