// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace hitscope {

/// Perceptually uniform maps from [0, 1] to colours. CoolWarm diverges: its middle is neutral.
enum class ColourMap : std::uint8_t { Viridis, Cividis, CoolWarm };
inline constexpr int kColourMaps = 3;

/// Red, green, blue of 256 evenly spaced places, sRGB.
using ColourTable = std::array<std::array<std::uint8_t, 3>, 256>;
[[nodiscard]] const ColourTable& colourTable(ColourMap map);

}  // namespace hitscope
