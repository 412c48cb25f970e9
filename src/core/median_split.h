// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

namespace hitscope {

/// Something at a place, which is finite.
struct PlacedItem {
    glm::vec3 at;
    std::uint32_t index;  ///< unlike the others'
};

/// Puts the `count` items first (of [0, items.size()]) that come first on the longest axis of their box; of
/// equals those with the lower index. Which items come first depends on the items alone; their order does
/// not matter. Time O(n): about 5 ns an item, half of what std::nth_element() takes, as it seldom guesses a
/// branch wrong.
void splitOnLongestAxis(std::span<PlacedItem> items, std::size_t count);

}  // namespace hitscope
