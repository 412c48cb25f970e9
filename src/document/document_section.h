// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace hitscope {

/// What stands at the top of a session file, in its order; a journal replaces each as a whole.
enum class Section : std::uint8_t {
    Scene,
    Targets,
    Constants,
    Projectile,
    Simulation,
    Lights,
    Cameras,
    Display,
    Selection,
    Positions,
    Hits,
};
inline constexpr std::array<std::string_view, 11> kSections{
    "scene",   "targets", "constants", "projectile", "simulation", "lights",
    "cameras", "display", "selection", "positions",  "hits"};

}  // namespace hitscope
