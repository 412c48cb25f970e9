// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "render/pixel_area.h"

namespace hitscope::render {

/// How deep a picture reaches, by squares of a few pixels: tells what is hidden by what is in it.
class FrontDepths {
public:
    /// depths: of the depth buffer in that area of the picture, one a pixel, row by row from the lower left;
    /// width * height of them. off: pixels that what is drawn behind may be off from the picture.
    FrontDepths(const PixelArea& area, std::span<const float> depths, int off = 0);
    /// Of a picture that starts at `left` in the bound framebuffer, which has one sample a pixel. Waits until
    /// it is drawn.
    [[nodiscard]] static FrontDepths ofBound(int left, const PixelArea& area, int off = 0);

    /// Whether what is bound has one sample a pixel.
    [[nodiscard]] static bool areReadable();

    [[nodiscard]] int off() const { return m_off; }

    /// Whether all pixels of that part of the area show something nearer. An empty part hides nothing.
    [[nodiscard]] bool hide(const PixelArea& part, float depth) const;

private:
    static constexpr int kTile = 2;  // pixels

    PixelArea m_area;
    int m_off;
    int m_columns;
    int m_rows;
    std::vector<float> m_farthest;  ///< of each tile's
};

}  // namespace hitscope::render
