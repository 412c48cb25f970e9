// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "view/lights.h"

namespace hitscope {

/// The lights as a list: the directional light, the point lights, the spotlight.
enum LightRow : int { DirectionalRow, FirstPointRow, SpotRow = FirstPointRow + 4, LightRowCount };

[[nodiscard]] inline bool isPointRow(int row) {
    return row >= FirstPointRow && row < SpotRow;
}

// row: [0, LightRowCount).
[[nodiscard]] bool& lightOn(Lights& lights, int row);
[[nodiscard]] LightTerms& lightTerms(Lights& lights, int row);
/// Null where the light has none, as the directional light.
[[nodiscard]] Attenuation* lightAttenuation(Lights& lights, int row);
[[nodiscard]] glm::vec3* lightPosition(Lights& lights, int row);
/// Null for point lights.
[[nodiscard]] glm::vec3* lightDirection(Lights& lights, int row);

/// "#rrggbb" in sRGB, of linear RGB.
[[nodiscard]] QString colourName(const glm::vec3& linear);
/// Linear RGB of sRGB, both [0, 1].
[[nodiscard]] glm::vec3 linearColour(float red, float green, float blue);

}  // namespace hitscope
