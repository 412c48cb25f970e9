// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hitscope {

/// A rectangle of a picture's pixels. It may stick out of the picture; nothing shows there.
struct PixelArea {
    int x = 0;  ///< of its lower left pixel; (0, 0) is the picture's lower left one
    int y = 0;
    int width = 0;
    int height = 0;
};

}  // namespace hitscope
