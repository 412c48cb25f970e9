// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/frame_times.h"

namespace hitscope {

/// "8.3 ms": a frame time with one decimal, from 100 ms on with none; "1.2 s": from a second on.
[[nodiscard]] QString frameTimeText(double seconds);

/// While frames are drawn what one costs and the rate that this allows, "8.3 ms (120 FPS)"; else "Idle", with
/// what the last one cost where there was one. scale: part of the picture's width and height that the last
/// frame was drawn with; said where it is less than 1.
[[nodiscard]] QString frameRateText(const FrameTimes::Summary& summary, float scale = 1.0f);

}  // namespace hitscope
