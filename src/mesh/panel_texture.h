// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/image.h"

namespace hitscope {

/// A picture of size x size pixels to put on targets: riveted metal panels in worn paint, which go on
/// seamlessly over its edges, with detail down to the single pixel, so that no size is as good as a smaller
/// one. The same size and seed give the same picture. Takes about a second for 4096; on any thread, and on
/// several of its own. size >= 4.
[[nodiscard]] Image makePanelTexture(int size, std::uint32_t seed = 1);

}  // namespace hitscope
