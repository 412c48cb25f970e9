// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/frame_times.h"
#include "view/picture_detail.h"

namespace hitscope {

/// "8.3 ms": a frame time with one decimal, from 100 ms on with none; "1.2 s": from a second on.
[[nodiscard]] QString frameTimeText(double seconds);

/// While frames are drawn what one costs and the rate that this allows, "8.3 ms (120 FPS)"; else "Idle", with
/// what the last one cost where there was one. detail: of the last frame; said where it was not all.
[[nodiscard]] QString frameRateText(const FrameTimes::Summary& summary, const PictureDetail& detail = {});

}  // namespace hitscope
