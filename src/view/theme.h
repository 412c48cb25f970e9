// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "view/display_options.h"

namespace hitscope {

/// What a theme paints with. Linear where light falls on it, sRGB where it is a mark of the interface.
struct ThemeColours {
    glm::vec3 backgroundTop;     ///< sRGB
    glm::vec3 backgroundBottom;  ///< sRGB
    glm::vec3 floor;             ///< linear, diffuse
    glm::vec4 floorLines;        ///< sRGB, opacity
    float contactShade;          ///< [0, 1]
    glm::vec4 wire;              ///< sRGB, opacity: over shaded surfaces
    glm::vec4 wireOnly;          ///< sRGB, opacity: without them
    glm::vec4 needles;           ///< sRGB, opacity: normals
    glm::vec4 dots;              ///< sRGB, opacity: vertices
    glm::vec3 cutFill;           ///< sRGB: inside of what a cutting plane cuts
    glm::vec3 accent;            ///< sRGB: what is selected
};

[[nodiscard]] const ThemeColours& themeColours(Theme theme);
/// IEC 61966-2-1.
[[nodiscard]] glm::vec3 toLinear(const glm::vec3& srgb);

}  // namespace hitscope
