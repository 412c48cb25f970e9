// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace hitscope {

/// An 8-bit RGBA picture, rows from top to bottom, no padding. pixels.size() == 4 * width * height.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels;
    /// What is saved with it where the format has a place for texts: key and text.
    std::vector<std::pair<std::string, std::string>> notes = {};

    [[nodiscard]] bool empty() const { return pixels.empty(); }
};

}  // namespace hitscope
