// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "deform/change_quantity.h"
#include "view/colour_map.h"

namespace hitscope {

/// Values at the ends of a colour map, in the quantity's unit; low < high.
struct ChangeRange {
    float low = 0.0f;
    float high = 1.0f;
    bool operator==(const ChangeRange&) const = default;
};

/// How one quantity is coloured.
struct QuantityStyle {
    ColourMap map = ColourMap::Viridis;
    bool automatic = true;  ///< the range follows the changed vertices
    ChangeRange fixed;      ///< it, where it does not
    bool operator==(const QuantityStyle&) const = default;
};

/// CoolWarm about 0 for what has a sign, Viridis for the rest; fixed ranges that suit a few hits with the
/// constants of the first start.
[[nodiscard]] std::array<QuantityStyle, kChangeQuantities> defaultQuantityStyles();

/// Surfaces coloured by how much their vertices changed.
struct ChangeMapOptions {
    bool on = false;
    ChangeQuantity quantity = ChangeQuantity::Displacement;
    bool isolines = false;
    std::array<QuantityStyle, kChangeQuantities> styles = defaultQuantityStyles();

    [[nodiscard]] const QuantityStyle& style() const { return styles[static_cast<std::size_t>(quantity)]; }
    [[nodiscard]] QuantityStyle& style() { return styles[static_cast<std::size_t>(quantity)]; }
    bool operator==(const ChangeMapOptions&) const = default;
};

enum class GhostMode : std::uint8_t { Off, Wire, Translucent };
inline constexpr float kLargestExaggeration = 20.0f;

/// The original beside what became of it.
struct BeforeAfterOptions {
    GhostMode ghost = GhostMode::Off;  ///< of the original
    bool wipe = false;                 ///< the original left of a line, the deformed right of it
    float wipeAt = 0.5f;               ///< where the line is, of the picture's width
    float exaggeration = 1.0f;         ///< [1, kLargestExaggeration]; for the eye only
    bool operator==(const BeforeAfterOptions&) const = default;
};

/// A colour map as a frame draws it.
struct ShownChange {
    ChangeQuantity quantity = ChangeQuantity::Displacement;
    ColourMap map = ColourMap::Viridis;
    ChangeRange range;
    float isolineStep = 0.0f;  ///< 0: none
    bool operator==(const ShownChange&) const = default;
};

/// A step of 1, 2 or 5 times a power of ten that cuts the range into at most `parts`.
[[nodiscard]] double niceStep(double low, double high, int parts);
inline constexpr int kIsolines = 10;  ///< at most, across the range

}  // namespace hitscope
