// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "render/pixel_area.h"

namespace hitscope::render {

/// How deep a picture reaches, by squares of a few pixels: tells what is hidden by what is in it.
class FrontDepths {
public:
    /// depths: of the depth buffer, one a pixel, row by row from the lower left; width * height of them.
    FrontDepths(int width, int height, std::span<const float> depths);

    /// Whether all pixels of that part of the picture show something nearer. An empty part hides nothing.
    [[nodiscard]] bool hide(const PixelArea& part, float depth) const;

private:
    static constexpr int kTile = 4;  // pixels

    int m_columns;
    int m_rows;
    std::vector<float> m_farthest;  ///< of each tile's
};

}  // namespace hitscope::render
