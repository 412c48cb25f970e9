// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "view/camera.h"

namespace hitscope {

/// A view along an axis: from the front one looks along -z, with x to the right.
enum class StandardView : std::uint8_t { Front, Back, Right, Left, Top, Bottom };

inline constexpr std::array<StandardView, 6> kStandardViews{StandardView::Front, StandardView::Back,
                                                            StandardView::Right, StandardView::Left,
                                                            StandardView::Top,   StandardView::Bottom};

/// The camera turned about a point to that view; the point stays where it is in the picture, distance and
/// projection as they are.
[[nodiscard]] Camera turnedTo(StandardView view, const Camera& camera, const glm::vec3& about);

/// Which of the views the camera has; nothing if none.
[[nodiscard]] std::optional<StandardView> standardViewOf(const Camera& camera);

}  // namespace hitscope
