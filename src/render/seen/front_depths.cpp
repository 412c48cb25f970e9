// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/seen/front_depths.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstddef>

namespace hitscope::render {

FrontDepths FrontDepths::ofBound(int left, const PixelArea& area, int off) {
    std::vector<float> depths(static_cast<std::size_t>(area.width) * static_cast<std::size_t>(area.height));
    glReadPixels(left + area.x, area.y, area.width, area.height, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    return {area, depths, off};
}

bool FrontDepths::areReadable() {
    GLint samples = 0;
    glGetIntegerv(GL_SAMPLE_BUFFERS, &samples);
    return samples == 0;
}

FrontDepths::FrontDepths(const PixelArea& area, std::span<const float> depths, int off)
    : m_area(area),
      m_off(off),
      m_columns((area.width + kTile - 1) / kTile),
      m_rows((area.height + kTile - 1) / kTile),
      m_farthest(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows), 0.0f) {
    const int width = area.width;
    for (int y = 0; y < area.height; ++y) {
        const float* row = depths.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
        float* tile =
            m_farthest.data() + static_cast<std::size_t>(y / kTile) * static_cast<std::size_t>(m_columns);
        for (int x = 0; x < width; x += kTile, ++tile) {
            *tile = std::max(*tile, *std::max_element(row + x, row + std::min(x + kTile, width)));
        }
    }
}

bool FrontDepths::hide(const PixelArea& part, float depth) const {
    const PixelArea seen = intersected(part, m_area);
    if (seen.empty()) {
        return false;
    }
    const int left = (seen.x - m_area.x) / kTile;
    const int low = (seen.y - m_area.y) / kTile;
    const int right = (seen.x - m_area.x + seen.width + kTile - 1) / kTile;
    const int high = (seen.y - m_area.y + seen.height + kTile - 1) / kTile;
    for (int row = low; row < high; ++row) {
        for (int column = left; column < right; ++column) {
            if (!(m_farthest[static_cast<std::size_t>(row) * static_cast<std::size_t>(m_columns) +
                             static_cast<std::size_t>(column)] < depth)) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace hitscope::render
