// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "physics/projectile_settings.h"

namespace hitscope {

/// How what is shot by hand gets to where it is aimed at.
enum class FlightMode : std::uint8_t {
    Quick,    ///< flies there in kQuickFlight; size and fall go by the target's size
    Instant,  ///< no flight: it hits where the line of sight does; size as above
    Paper,    ///< flies as in the paper: 30 m/s, 0.1 m, 5 s, whatever the target's size
    Own,      ///< flies as the projectile settings say
};

struct FlightModeTraits {
    FlightMode mode;
    std::string_view key;          ///< as in settings: "quick"
    std::string_view name;         ///< as in the interface
    std::string_view description;  ///< one sentence for tool tips
};

/// By FlightMode.
[[nodiscard]] const std::array<FlightModeTraits, 4>& allFlightModes();

/// Seconds of simulated time that a quick flight takes, wherever it starts.
inline constexpr float kQuickFlight = 0.1f;

/// The projectile that is shot in `mode` at a target whose largest extent is `extent` metres and which is
/// `distance` metres away. Speed, radius, lifetime and gravity are the mode's, all else is as in `own`; a
/// quick projectile has the momentum of the paper's and passes through others. Within projectileParameters().
[[nodiscard]] ProjectileSettings projectileOf(FlightMode mode, const ProjectileSettings& own, float extent,
                                              float distance);

}  // namespace hitscope
