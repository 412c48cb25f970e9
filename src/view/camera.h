// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/bounds.h"

namespace hitscope {

struct Ray {
    glm::vec3 origin{0.0f};
    glm::vec3 direction{0.0f, 0.0f, -1.0f};  ///< unit
};

enum class Projection : std::uint8_t { Perspective, Orthographic };

/// A turntable camera: orbits about a pivot, y stays up. Angles in radians, lengths in metres.
///
/// Both projections show the pivot's plane at the same size, so that switching changes little. An
/// orthographic picture has no eye: eye() is where the perspective one would be, and what lies behind it is
/// seen too.
class Camera {
public:
    [[nodiscard]] glm::vec3 eye() const;
    [[nodiscard]] glm::vec3 forward() const;  ///< unit
    [[nodiscard]] glm::vec3 right() const;    ///< unit
    [[nodiscard]] glm::vec3 up() const;       ///< unit
    [[nodiscard]] glm::vec3 pivot() const { return m_pivot; }
    [[nodiscard]] float distance() const { return m_distance; }
    [[nodiscard]] float yaw() const { return m_yaw; }                  ///< [-pi, pi]; 0 looks along -z
    [[nodiscard]] float pitch() const { return m_pitch; }              ///< [-pi/2, pi/2]; positive looks down
    [[nodiscard]] float fieldOfView() const { return m_fieldOfView; }  ///< vertical
    [[nodiscard]] Projection projectionKind() const { return m_projection; }
    [[nodiscard]] bool isOrthographic() const { return m_projection == Projection::Orthographic; }
    /// What the picture's height takes up at that distance from the eye, metres.
    [[nodiscard]] float heightAt(float distance) const;

    [[nodiscard]] glm::mat4 view() const;
    /// aspect: width / height, > 0. Near and far planes follow the distance and the scene radius.
    [[nodiscard]] glm::mat4 projection(float aspect) const;
    /// How far from below the pivot a floor goes on in the picture, metres; within the far plane.
    [[nodiscard]] float floorReach() const;
    /// Through a point of the picture; ndc in [-1, 1]^2, y up. Starts at the eye, or, orthographic, in front
    /// of all that is seen.
    [[nodiscard]] Ray rayThrough(const glm::vec2& ndc, float aspect) const;

    /// Metres and radians; the distance within zoom()'s limits.
    void setPivot(const glm::vec3& pivot, float yaw, float pitch, float distance);
    /// Likewise, a place that a camera had: frame() and zoomAbout() lead beyond those limits, so the distance
    /// is as given. One that is not finite or not above zero changes nothing of it.
    void restore(const glm::vec3& pivot, float yaw, float pitch, float distance);
    [[nodiscard]] float sceneRadius() const { return m_sceneRadius; }
    void setSceneRadius(float radius) { m_sceneRadius = radius; }
    void setProjection(Projection projection) { m_projection = projection; }
    void setFieldOfView(float radians);  ///< clamped to [kNarrowest, kWidest]
    void orbit(float yaw, float pitch);  ///< by these angles; pitch stops at the poles
    /// Likewise, about another point than the pivot: it stays where it is in the picture.
    void orbitAbout(const glm::vec3& point, float yaw, float pitch);
    void look(float yaw, float pitch);  ///< likewise, about the eye
    /// Moves the pivot so that what is under the cursor follows it; delta in fractions of the picture's
    /// height.
    void pan(const glm::vec2& delta);
    void zoom(float factor);  ///< distance *= factor, within sensible limits
    /// Likewise, about another point than the pivot: it stays where it is in the picture. The pivot comes to
    /// be as far from the eye as the point.
    void zoomAbout(const glm::vec3& point, float factor);
    void fly(const glm::vec3& step);                 ///< right, up, forward, in metres
    void recentre(const glm::vec3& point);           ///< pivot there, keeping eye direction and distance
    void frame(const Bounds& bounds, float aspect);  ///< all of the box in the picture

    static constexpr float kNarrowest = 0.0872665f;  ///< field of view, 5 degrees
    static constexpr float kWidest = 2.0943951f;     ///< 120 degrees

    bool operator==(const Camera&) const = default;

private:
    [[nodiscard]] float nearPlane() const;
    [[nodiscard]] float farPlane() const;

    glm::vec3 m_pivot{0.0f};
    float m_yaw = 0.6f;
    float m_pitch = 0.35f;
    float m_distance = 10.0f;
    float m_fieldOfView = 0.87266463f;  ///< vertical, 50 degrees
    float m_sceneRadius = 100.0f;
    Projection m_projection = Projection::Perspective;
};

}  // namespace hitscope
