// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <glm/vec3.hpp>
#include <optional>

#include "view/camera.h"

namespace hitscope {

class Viewport;

/// Cosine between a direction and the line of sight beyond which it is no direction in the picture.
constexpr float kAlongSight = 0.97f;

/// Logical pixels.
[[nodiscard]] double lengthOf(const QPointF& way);
/// Where a point of the world is, in logical pixels of the viewport, side by side in the left of the two
/// pictures. Nothing: it is behind the eye.
[[nodiscard]] std::optional<QPointF> placeInPicture(Viewport& viewport, const glm::vec3& point);
/// The height of a logical pixel at a point of the world, metres; behind the eye: at it.
[[nodiscard]] float pixelAt(Viewport& viewport, const glm::vec3& point);
/// How far along `along` (unit) from `start` the line through there comes nearest to a ray, metres. Not
/// finite where both are parallel.
[[nodiscard]] float nearestAlong(const Ray& ray, const glm::vec3& start, const glm::vec3& along);

}  // namespace hitscope
