// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/seen/seen_area.h"

#include <glm/common.hpp>

namespace hitscope::render {

namespace {

constexpr float kLeastClipWidth = 1e-6f;  // of what is in front of the eye

}  // namespace

std::array<glm::vec3, 8> cornersOf(const Bounds& box) {
    std::array<glm::vec3, 8> corners{};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        corners[i] = {(i & 1) != 0 ? box.max.x : box.min.x, (i & 2) != 0 ? box.max.y : box.min.y,
                      (i & 4) != 0 ? box.max.z : box.min.z};
    }
    return corners;
}

bool SeenArea::add(const Bounds& box) {
    for (const glm::vec3& corner : cornersOf(box)) {
        const glm::vec4 clip = m_toClip * glm::vec4(corner, 1.0f);
        if (!(clip.w > kLeastClipWidth)) {
            return false;
        }
        m_bounds.add(glm::vec3(clip) / clip.w);
    }
    return true;
}

PixelArea SeenArea::in(const glm::ivec2& picture, int margin) const {
    if (m_bounds.empty()) {
        return {};
    }
    const glm::vec2 size(picture);
    const glm::vec2 low = glm::clamp(0.5f * (glm::vec2(m_bounds.min) + 1.0f), 0.0f, 1.0f) * size;
    const glm::vec2 high = glm::clamp(0.5f * (glm::vec2(m_bounds.max) + 1.0f), 0.0f, 1.0f) * size;
    const glm::ivec2 first = glm::max(glm::ivec2(glm::floor(low)) - margin, glm::ivec2(0));
    const glm::ivec2 last = glm::min(glm::ivec2(glm::ceil(high)) + margin, picture);
    return {first.x, first.y, last.x - first.x, last.y - first.y};
}

}  // namespace hitscope::render
