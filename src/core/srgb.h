// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace hitscope {

// The transfer functions of sRGB (IEC 61966-2-1). Values are in [0, 1].

template <class Number>
[[nodiscard]] Number linearOfSrgb(Number srgb) {
    return srgb <= Number(0.04045) ? srgb / Number(12.92)
                                   : std::pow((srgb + Number(0.055)) / Number(1.055), Number(2.4));
}

template <class Number>
[[nodiscard]] Number srgbOfLinear(Number linear) {
    return linear <= Number(0.0031308)
               ? Number(12.92) * linear
               : Number(1.055) * std::pow(linear, Number(1) / Number(2.4)) - Number(0.055);
}

/// As eight bits; what is outside [0, 1] becomes 0 or 255.
[[nodiscard]] inline std::uint8_t srgbByteOfLinear(float linear) {
    return static_cast<std::uint8_t>(std::lround(255.0f * srgbOfLinear(std::clamp(linear, 0.0f, 1.0f))));
}

}  // namespace hitscope
