// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/pixel_area.h"

namespace hitscope::render {

/// Where in a picture there are marked pixels, by squares of a few pixels.
class MarkedTiles {
public:
    /// marks: one a pixel of `area`, row by row from the lower left; 0: not marked.
    MarkedTiles(const PixelArea& area, std::span<const std::uint8_t> marks);
    /// All pixels of these parts are marked, and others near them.
    [[nodiscard]] static MarkedTiles around(std::span<const PixelArea> parts);

    /// Whether there may be one in that part of the picture; costs the same for each.
    [[nodiscard]] bool any(const PixelArea& part) const;
    /// Around all marked squares.
    [[nodiscard]] const PixelArea& area() const { return m_area; }
    /// Of all marked squares.
    [[nodiscard]] std::size_t pixels() const;
    /// The marked squares as rectangles that do not overlap.
    [[nodiscard]] std::vector<PixelArea> rectangles() const;

private:
    explicit MarkedTiles(const PixelArea& area);
    void addUp();
    [[nodiscard]] bool isMarked(int column, int row) const;
    static constexpr int kTile = 8;  // pixels
    [[nodiscard]] std::uint32_t& sum(int column, int row);
    [[nodiscard]] std::uint32_t sum(int column, int row) const;

    PixelArea m_area;
    int m_columns;
    int m_rows;
    /// Marked tiles in the columns and rows before: the corner of four tiles, one more each way than tiles.
    std::vector<std::uint32_t> m_sums;
};

}  // namespace hitscope::render
