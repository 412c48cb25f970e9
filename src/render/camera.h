// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/bounds.h"

namespace hitscope {

struct Ray {
    glm::vec3 origin{0.0f};
    glm::vec3 direction{0.0f, 0.0f, -1.0f};  ///< unit
};

/// A turntable camera: orbits about a pivot, y stays up. Angles in radians, lengths in metres.
class Camera {
public:
    [[nodiscard]] glm::vec3 eye() const;
    [[nodiscard]] glm::vec3 forward() const;  ///< unit
    [[nodiscard]] glm::vec3 right() const;    ///< unit
    [[nodiscard]] glm::vec3 up() const;       ///< unit
    [[nodiscard]] glm::vec3 pivot() const { return m_pivot; }
    [[nodiscard]] float distance() const { return m_distance; }
    [[nodiscard]] float fieldOfView() const { return m_fieldOfView; }

    [[nodiscard]] glm::mat4 view() const;
    /// aspect: width / height, > 0. Near and far planes follow the distance and the scene radius.
    [[nodiscard]] glm::mat4 projection(float aspect) const;
    /// How far from below the pivot a floor goes on in the picture, metres; within the far plane.
    [[nodiscard]] float floorReach() const;
    /// Through a point of the picture; ndc in [-1, 1]^2, y up.
    [[nodiscard]] Ray rayThrough(const glm::vec2& ndc, float aspect) const;

    void setPivot(const glm::vec3& pivot, float yaw, float pitch, float distance);
    void setSceneRadius(float radius) { m_sceneRadius = radius; }
    void orbit(float yaw, float pitch);  ///< by these angles; pitch stays short of the poles
    /// Moves the pivot so that what is under the cursor follows it; delta in fractions of the picture's
    /// height.
    void pan(const glm::vec2& delta);
    void zoom(float factor);                         ///< distance *= factor, within sensible limits
    void fly(const glm::vec3& step);                 ///< right, up, forward, in metres
    void recentre(const glm::vec3& point);           ///< pivot there, keeping eye direction and distance
    void frame(const Bounds& bounds, float aspect);  ///< all of the box in the picture

private:
    glm::vec3 m_pivot{0.0f};
    float m_yaw = 0.6f;
    float m_pitch = 0.35f;
    float m_distance = 10.0f;
    float m_fieldOfView = 0.8726646f;  ///< vertical, 50 degrees
    float m_sceneRadius = 100.0f;
};

}  // namespace hitscope
