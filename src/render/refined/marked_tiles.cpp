// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/refined/marked_tiles.h"

#include <algorithm>

namespace hitscope::render {

MarkedTiles::MarkedTiles(const PixelArea& area, std::span<const std::uint8_t> marks)
    : m_area(area),
      m_columns((area.width + kTile - 1) / kTile),
      m_rows((area.height + kTile - 1) / kTile),
      m_sums(static_cast<std::size_t>(m_columns + 1) * static_cast<std::size_t>(m_rows + 1)) {
    const auto width = static_cast<std::size_t>(area.width);
    for (std::size_t i = 0; i < marks.size(); ++i) {
        if (marks[i] != 0) {
            sum(static_cast<int>(i % width) / kTile + 1, static_cast<int>(i / width) / kTile + 1) = 1;
        }
    }
    for (int row = 1; row <= m_rows; ++row) {
        for (int column = 1; column <= m_columns; ++column) {
            sum(column, row) += sum(column - 1, row) + sum(column, row - 1) - sum(column - 1, row - 1);
        }
    }
}

std::uint32_t& MarkedTiles::sum(int column, int row) {
    return m_sums[static_cast<std::size_t>(row) * static_cast<std::size_t>(m_columns + 1) +
                  static_cast<std::size_t>(column)];
}

std::uint32_t MarkedTiles::sum(int column, int row) const {
    return const_cast<MarkedTiles*>(this)->sum(column, row);
}

bool MarkedTiles::any(const PixelArea& part) const {
    if (part.width <= 0 || part.height <= 0) {
        return false;
    }
    const int left = std::max(part.x - m_area.x, 0) / kTile;
    const int low = std::max(part.y - m_area.y, 0) / kTile;
    const int right = (std::min(part.x + part.width - m_area.x, m_area.width) + kTile - 1) / kTile;
    const int high = (std::min(part.y + part.height - m_area.y, m_area.height) + kTile - 1) / kTile;
    return right > left && high > low &&
           sum(right, high) + sum(left, low) - sum(left, high) - sum(right, low) > 0;
}

}  // namespace hitscope::render
