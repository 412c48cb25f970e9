// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/refined/marked_tiles.h"

#include <algorithm>

namespace hitscope::render {

MarkedTiles::MarkedTiles(const PixelArea& area)
    : m_area(area),
      m_columns((area.width + kTile - 1) / kTile),
      m_rows((area.height + kTile - 1) / kTile),
      m_sums(static_cast<std::size_t>(m_columns + 1) * static_cast<std::size_t>(m_rows + 1)) {}

MarkedTiles::MarkedTiles(const PixelArea& area, std::span<const std::uint8_t> marks) : MarkedTiles(area) {
    const auto width = static_cast<std::size_t>(area.width);
    for (std::size_t i = 0; i < marks.size(); ++i) {
        if (marks[i] != 0) {
            sum(static_cast<int>(i % width) / kTile + 1, static_cast<int>(i / width) / kTile + 1) = 1;
        }
    }
    addUp();
}

MarkedTiles MarkedTiles::around(std::span<const PixelArea> parts) {
    PixelArea all;
    for (const PixelArea& part : parts) {
        all = united(all, part);
    }
    all.width = (std::max(all.width, 0) + kTile - 1) / kTile * kTile;
    all.height = (std::max(all.height, 0) + kTile - 1) / kTile * kTile;
    MarkedTiles tiles(all);
    for (const PixelArea& part : parts) {
        if (part.empty()) {
            continue;
        }
        const int right = (part.x + part.width - 1 - all.x) / kTile;
        const int high = (part.y + part.height - 1 - all.y) / kTile;
        for (int row = (part.y - all.y) / kTile; row <= high; ++row) {
            for (int column = (part.x - all.x) / kTile; column <= right; ++column) {
                tiles.sum(column + 1, row + 1) = 1;
            }
        }
    }
    tiles.addUp();
    return tiles;
}

void MarkedTiles::addUp() {
    for (int row = 1; row <= m_rows; ++row) {
        for (int column = 1; column <= m_columns; ++column) {
            sum(column, row) += sum(column - 1, row) + sum(column, row - 1) - sum(column - 1, row - 1);
        }
    }
}

bool MarkedTiles::isMarked(int column, int row) const {
    return sum(column + 1, row + 1) + sum(column, row) > sum(column, row + 1) + sum(column + 1, row);
}

std::size_t MarkedTiles::pixels() const {
    return std::size_t{kTile * kTile} * sum(m_columns, m_rows);
}

std::vector<PixelArea> MarkedTiles::rectangles() const {
    std::vector<PixelArea> found;
    std::size_t below = 0;  // the first of the row before
    for (int row = 0; row < m_rows; ++row) {
        const std::size_t first = found.size();
        for (int column = 0; column < m_columns; ++column) {
            if (!isMarked(column, row)) {
                continue;
            }
            const int begin = column;
            while (column < m_columns && isMarked(column, row)) {
                ++column;
            }
            found.push_back(
                {m_area.x + begin * kTile, m_area.y + row * kTile, (column - begin) * kTile, kTile});
        }
        const bool isSame = first > below && found.size() - first == first - below &&
                            std::equal(found.begin() + static_cast<std::ptrdiff_t>(first), found.end(),
                                       found.begin() + static_cast<std::ptrdiff_t>(below),
                                       [](const PixelArea& a, const PixelArea& b) {
                                           return a.x == b.x && a.width == b.width;
                                       });
        if (!isSame) {
            below = first;
            continue;
        }
        found.resize(first);
        for (std::size_t i = below; i < first; ++i) {
            found[i].height += kTile;
        }
    }
    return found;
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
