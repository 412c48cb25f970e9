// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace hitscope {

/// Seconds left of something that has come to `fraction`, [0, 1], in so many seconds, if it goes on as
/// before; nothing where it is too early to say, or `fraction` is not known (negative).
[[nodiscard]] constexpr std::optional<double> remainingSeconds(double fraction, double seconds) {
    constexpr double kEarliest = 2.0;  // seconds
    constexpr double kLeast = 0.02;
    if (!(seconds >= kEarliest && fraction >= kLeast && fraction <= 1.0)) {
        return std::nullopt;
    }
    return seconds * (1.0 - fraction) / fraction;
}

}  // namespace hitscope
