// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/handles/handle_geometry.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "viewport/viewport.h"

namespace hitscope {

double lengthOf(const QPointF& way) {
    return std::hypot(way.x(), way.y());
}

std::optional<QPointF> placeInPicture(Viewport& viewport, const glm::vec3& point) {
    const Camera& camera = viewport.camera();
    const glm::vec4 clip =
        camera.projection(viewport.navigation().aspect()) * camera.view() * glm::vec4(point, 1.0f);
    if (clip.w <= 0.0f) {
        return std::nullopt;
    }
    const double width = viewport.options().sideBySide ? viewport.width() / 2.0 : viewport.width();
    return QPointF(0.5 * (1.0 + static_cast<double>(clip.x / clip.w)) * width,
                   0.5 * (1.0 - static_cast<double>(clip.y / clip.w)) * viewport.height());
}

float pixelAt(Viewport& viewport, const glm::vec3& point) {
    const Camera& camera = viewport.camera();
    const float away = glm::dot(point - camera.eye(), camera.forward());
    return camera.heightAt(std::max(away, 0.0f)) / static_cast<float>(viewport.height());
}

float nearestAlong(const Ray& ray, const glm::vec3& start, const glm::vec3& along) {
    const glm::vec3 apart = start - ray.origin;
    const float cosine = glm::dot(along, ray.direction);
    return (cosine * glm::dot(ray.direction, apart) - glm::dot(along, apart)) / (1.0f - cosine * cosine);
}

}  // namespace hitscope
