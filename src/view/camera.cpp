// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

namespace hitscope {
namespace {

constexpr float kHighestPitch = 1.5707962f;  // the last number before a right angle, so that up stays up
constexpr float kLargestNear = 0.05f;        // metres: half a projectile's radius
constexpr float kNearOfDistance = 0.01f;     // of the distance to the pivot
constexpr float kLeastNearOfFar =
    1.0f / 2.0e4f;                     // 24 bits of depth still part 1/300 of the distance at the end
constexpr float kFloorOfScene = 2.5f;  // how far the floor goes on, in scene radii or distances
constexpr float kNearest = 1.0e-3f;    // of the distance to the pivot, in scene radii
constexpr float kFarthest = 10.0f;     // likewise
constexpr float kFrameMargin = 1.08f;  // around what is framed

}  // namespace

glm::vec3 Camera::forward() const {
    return {-std::cos(m_pitch) * std::sin(m_yaw), -std::sin(m_pitch), -std::cos(m_pitch) * std::cos(m_yaw)};
}

glm::vec3 Camera::right() const {
    return {std::cos(m_yaw), 0.0f, -std::sin(m_yaw)};
}

glm::vec3 Camera::up() const {
    return glm::cross(right(), forward());
}

glm::vec3 Camera::eye() const {
    return m_pivot - forward() * m_distance;
}

glm::mat4 Camera::view() const {
    const glm::vec3 from = eye();
    // From the axes and not from a point far ahead, which would lose the direction when the eye is far out.
    glm::mat4 rotation(1.0f);
    const glm::vec3 axes[3] = {right(), up(), -forward()};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            rotation[column][row] = axes[row][column];
        }
    }
    return glm::translate(rotation, -from);
}

float Camera::farPlane() const {
    // The corners of the floor's square are sqrt(2) of its reach away.
    return m_distance + 1.5f * floorReach();
}

float Camera::nearPlane() const {
    if (isOrthographic()) {
        return m_distance - 1.5f * floorReach();  // as far before the pivot as the other is behind it
    }
    return std::max(std::min(kLargestNear, kNearOfDistance * m_distance), kLeastNearOfFar * farPlane());
}

float Camera::heightAt(float distance) const {
    return 2.0f * (isOrthographic() ? m_distance : distance) * std::tan(0.5f * m_fieldOfView);
}

glm::mat4 Camera::projection(float aspect) const {
    // Metres: the product of both is a float, wherever a text puts the camera.
    const float nearest = std::min(nearPlane(), 1.0e15f);
    const float farthest = std::min(farPlane(), 1.0e18f);
    if (isOrthographic()) {
        const float half = 0.5f * heightAt(m_distance);
        return glm::ortho(-half * aspect, half * aspect, -half, half, nearest, farthest);
    }
    return glm::perspective(m_fieldOfView, aspect, nearest, farthest);
}

float Camera::floorReach() const {
    return kFloorOfScene * std::max(m_sceneRadius, m_distance);
}

Ray Camera::rayThrough(const glm::vec2& ndc, float aspect) const {
    const float half = 0.5f * heightAt(1.0f);
    const glm::vec3 aside = right() * (ndc.x * half * aspect) + up() * (ndc.y * half);
    if (isOrthographic()) {
        return {eye() + aside + forward() * nearPlane(), forward()};
    }
    return {eye(), glm::normalize(forward() + aside)};
}

void Camera::setPivot(const glm::vec3& pivot, float yaw, float pitch, float distance) {
    restore(pivot, yaw, pitch, distance);
    zoom(1.0f);
}

void Camera::restore(const glm::vec3& pivot, float yaw, float pitch, float distance) {
    m_pivot = pivot;
    m_yaw = 0.0f;
    m_pitch = 0.0f;
    orbit(yaw, pitch);
    if (std::isfinite(distance) && distance > 0.0f) {
        m_distance = distance;
    }
}

void Camera::orbit(float yaw, float pitch) {
    m_yaw = std::remainder(m_yaw + yaw, glm::two_pi<float>());
    m_pitch = std::clamp(m_pitch + pitch, -kHighestPitch, kHighestPitch);
}

void Camera::orbitAbout(const glm::vec3& point, float yaw, float pitch) {
    // Where the pivot is as seen from the point, along the camera's own axes, does not change.
    const glm::vec3 away = m_pivot - point;
    const glm::vec3 seen(glm::dot(away, right()), glm::dot(away, up()), glm::dot(away, forward()));
    orbit(yaw, pitch);
    m_pivot = point + right() * seen.x + up() * seen.y + forward() * seen.z;
}

void Camera::look(float yaw, float pitch) {
    orbitAbout(eye(), yaw, pitch);
}

void Camera::setFieldOfView(float radians) {
    m_fieldOfView = std::clamp(radians, kNarrowest, kWidest);
}

void Camera::pan(const glm::vec2& delta) {
    m_pivot -= (right() * delta.x + up() * delta.y) * heightAt(m_distance);
}

void Camera::zoom(float factor) {
    m_distance = std::clamp(m_distance * factor, kNearest * m_sceneRadius, kFarthest * m_sceneRadius);
}

void Camera::zoomAbout(const glm::vec3& point, float factor) {
    const float depth = glm::dot(point - eye(), forward());
    if (!isOrthographic() && depth > 0.0f) {
        m_pivot = eye() + forward() * depth;  // which changes nothing of the picture
        m_distance = depth;
    }
    // Beyond a limit already, it goes no further, and does not jump back either.
    const float before = m_distance;
    const float nearest = std::min(kNearest * m_sceneRadius, before);
    const float farthest = std::max(kFarthest * m_sceneRadius, before);
    m_distance = std::clamp(before * factor, nearest, farthest);
    m_pivot = point + (m_pivot - point) * (m_distance / before);
}

void Camera::fly(const glm::vec3& step) {
    m_pivot += right() * step.x + up() * step.y + forward() * step.z;
}

void Camera::recentre(const glm::vec3& point) {
    m_pivot = point;
}

void Camera::frame(const Bounds& bounds, float aspect) {
    const glm::vec3 centre = bounds.centre();
    const glm::vec3 half = 0.5f * bounds.size();
    const float height = std::tan(0.5f * m_fieldOfView);
    float distance = 0.0f;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 offset = half * glm::vec3((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                                                  (corner & 4) != 0 ? 1 : -1);
        // The corner is in the picture when |x|, |y| <= (distance + depth) * half the picture's size there.
        const float depth = isOrthographic() ? 0.0f : glm::dot(offset, forward());
        const float x = std::abs(glm::dot(offset, right())) / (height * aspect);
        const float y = std::abs(glm::dot(offset, up())) / height;
        distance = std::max(distance, kFrameMargin * std::max(x, y) - depth);
    }
    m_pivot = centre;
    if (distance > 0.0f) {
        m_distance = distance;
    }
}

}  // namespace hitscope
