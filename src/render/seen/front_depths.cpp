// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/seen/front_depths.h"

#include <algorithm>
#include <cstddef>

namespace hitscope::render {

FrontDepths::FrontDepths(int width, int height, std::span<const float> depths)
    : m_columns((width + kTile - 1) / kTile),
      m_rows((height + kTile - 1) / kTile),
      m_farthest(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows), 0.0f) {
    for (int y = 0; y < height; ++y) {
        const float* row = depths.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
        float* tile =
            m_farthest.data() + static_cast<std::size_t>(y / kTile) * static_cast<std::size_t>(m_columns);
        for (int x = 0; x < width; x += kTile, ++tile) {
            *tile = std::max(*tile, *std::max_element(row + x, row + std::min(x + kTile, width)));
        }
    }
}

bool FrontDepths::hide(const PixelArea& part, float depth) const {
    if (part.width <= 0 || part.height <= 0) {
        return false;
    }
    const int left = std::max(part.x, 0) / kTile;
    const int low = std::max(part.y, 0) / kTile;
    const int right = std::min((part.x + part.width + kTile - 1) / kTile, m_columns);
    const int high = std::min((part.y + part.height + kTile - 1) / kTile, m_rows);
    for (int row = low; row < high; ++row) {
        for (int column = left; column < right; ++column) {
            if (!(m_farthest[static_cast<std::size_t>(row) * static_cast<std::size_t>(m_columns) +
                             static_cast<std::size_t>(column)] < depth)) {
                return false;
            }
        }
    }
    return right > left && high > low;
}

}  // namespace hitscope::render
