// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "scene/scene_gpu.h"
#include "session/target.h"

namespace hitscope {

/// Where points of a target's local frame fall in a picture. Pixels from its upper left corner.
class ScreenSpace {
public:
    ScreenSpace(const SceneGpu::View& view, const RigidTransform& transform);

    struct Point {
        glm::vec2 at{0.0f};  ///< pixels
        float depth = 0.0f;  ///< normalized device coordinates: -1 the near plane, 1 the far plane
        float w =
            1.0f;  ///< of the point in clip space: what is linear in the world is, over w, in the picture
        float pixelDepth = 0.0f;  ///< the depth that a pixel's width makes there
    };
    /// Nothing behind the eye.
    [[nodiscard]] std::optional<Point> project(const glm::vec3& local) const;

private:
    glm::mat4 m_toClip{1.0f};
    glm::mat4 m_projection{1.0f};
    glm::vec2 m_size{1.0f};
};

/// Even-odd rule; a point on the outline may fall on either side.
[[nodiscard]] bool isWithin(std::span<const glm::vec2> outline, const glm::vec2& point);

}  // namespace hitscope
