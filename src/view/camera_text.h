// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "core/result.h"
#include "view/camera.h"

namespace hitscope {

/// "camera pivot 0 1.5 0 yaw 34.4 pitch 20 distance 12 fov 50 perspective": metres and degrees, one line.
/// Parsed again it gives the same camera in every bit.
[[nodiscard]] std::string cameraText(const Camera& camera);

/// The camera that such a line describes; what the line does not hold (the scene's size) is `base`'s. Each
/// word has to be there once, in any order after "camera"; the error says which is missing or wrong. Angles
/// in degrees: yaw within 360, pitch within 90, fov 5 to 120; distance above 0, kept within what `base`
/// allows.
[[nodiscard]] Result<Camera> parseCamera(std::string_view text, const Camera& base);

}  // namespace hitscope
