// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/screen_space.h"

#include <cmath>

namespace hitscope {

ScreenSpace::ScreenSpace(const SceneGpu::View& view, const RigidTransform& transform)
    : m_size(static_cast<float>(view.width), static_cast<float>(view.height)) {
    glm::mat4 model = glm::mat4_cast(transform.rotation);
    model[3] = glm::vec4(transform.position, 1.0f);
    m_projection = view.camera.projection(m_size.x / m_size.y);
    m_toClip = m_projection * view.camera.view() * model;
}

std::optional<ScreenSpace::Point> ScreenSpace::project(const glm::vec3& local) const {
    const glm::vec4 clip = m_toClip * glm::vec4(local, 1.0f);
    if (clip.w <= 0.0f) {
        return std::nullopt;
    }
    const glm::vec3 normalized = glm::vec3(clip) / clip.w;
    // z / w by the distance from the eye, for perspective and parallel projections alike, times what a pixel
    // is wide there.
    const float slope =
        std::abs(m_projection[2][2] * clip.w - clip.z * m_projection[2][3]) / (clip.w * clip.w);
    const float pixel = 2.0f * clip.w / (m_projection[1][1] * m_size.y);
    return Point{{0.5f * (1.0f + normalized.x) * m_size.x, 0.5f * (1.0f - normalized.y) * m_size.y},
                 normalized.z,
                 clip.w,
                 slope * pixel};
}

bool isWithin(std::span<const glm::vec2> outline, const glm::vec2& point) {
    bool within = false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::vec2& a = outline[i];
        const glm::vec2& b = outline[(i + 1) % outline.size()];
        if ((a.y > point.y) != (b.y > point.y) &&
            point.x < a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y)) {
            within = !within;
        }
    }
    return within;
}

}  // namespace hitscope
