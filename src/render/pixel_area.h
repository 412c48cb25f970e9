// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace hitscope {

/// A rectangle of a picture's pixels. It may stick out of the picture; nothing shows there.
struct PixelArea {
    int x = 0;  ///< of its lower left pixel; (0, 0) is the picture's lower left one
    int y = 0;
    int width = 0;
    int height = 0;

    bool operator==(const PixelArea&) const = default;
    [[nodiscard]] bool empty() const { return width <= 0 || height <= 0; }
};

/// What both hold.
[[nodiscard]] inline PixelArea intersected(const PixelArea& a, const PixelArea& b) {
    const int x = std::max(a.x, b.x);
    const int y = std::max(a.y, b.y);
    return {x, y, std::min(a.x + a.width, b.x + b.width) - x, std::min(a.y + a.height, b.y + b.height) - y};
}

/// The least rectangle that holds both; one that is empty is nowhere.
[[nodiscard]] inline PixelArea united(const PixelArea& a, const PixelArea& b) {
    if (a.empty() || b.empty()) {
        return a.empty() ? b : a;
    }
    const int x = std::min(a.x, b.x);
    const int y = std::min(a.y, b.y);
    return {x, y, std::max(a.x + a.width, b.x + b.width) - x, std::max(a.y + a.height, b.y + b.height) - y};
}

/// With so many pixels more on all sides.
[[nodiscard]] inline PixelArea widened(const PixelArea& area, int by) {
    return {area.x - by, area.y - by, area.width + 2 * by, area.height + 2 * by};
}

}  // namespace hitscope
