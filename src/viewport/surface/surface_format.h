// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSurfaceFormat>

#include "core/result.h"

namespace hitscope {

/// Core profile and 24-bit depth: what every context of the window is made with. OpenGL 3.3, for which some
/// drivers give the newest that they have; or, once the driver has been asked (viewportFormat(),
/// checkOpenGl()), the newest up to 4.6 that it gives when asked for that.
[[nodiscard]] QSurfaceFormat baseSurfaceFormat();

/// Whether the driver is a software renderer. Needs a QGuiApplication; asks the driver once.
[[nodiscard]] bool isDrawnByCpu();

/// In the environment: has a QOpenGLWidget show what the CPU draws, too, with that many samples a pixel.
inline constexpr const char* kComposes = "HITSCOPE_COMPOSES";

/// What the viewport draws into: the base format, and 4x multisampling where a GPU does it. A software
/// renderer pays for every sample, so it gets one (or kComposes). Needs a QGuiApplication; asks the driver
/// once.
[[nodiscard]] QSurfaceFormat viewportFormat();

/// Whether there is OpenGL 3.3 here at all. Ask before making a Viewport: where there is none, Qt's OpenGL
/// widgets end the process. Needs a QGuiApplication; asks the driver once.
[[nodiscard]] Status checkOpenGl();

}  // namespace hitscope
