// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/navigation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hitscope {

namespace {

constexpr float kFlySpeed = 0.7f;    // camera distances a second
constexpr float kFastFactor = 3.0f;  // with Shift
constexpr float kStride = 0.15f;     // camera distances

}  // namespace

Navigation::Navigation(SurfaceAt surfaceAt, SceneNow scene, QObject* parent)
    : QObject(parent), m_surfaceAt(std::move(surfaceAt)), m_scene(std::move(scene)) {}

void Navigation::setSceneRadius(float radius) {
    m_camera.setSceneRadius(radius);
    if (m_glide.isRunning()) {
        setCamera(m_glide.goal(), Arrival::AtOnce);  // its ends were of another scene
    }
}

float Navigation::aspect() const {
    return static_cast<float>(std::max(m_size.width(), 1.0) / std::max(m_size.height(), 1.0));
}

Ray Navigation::rayAt(const QPointF& position) const {
    const bool isInSecond = m_hasSecond && position.x() >= m_size.width();
    return rayInFirst(isInSecond ? position - QPointF(m_size.width(), 0.0) : position);
}

Ray Navigation::rayInFirst(const QPointF& position) const {
    const auto fraction = [](double at, double size) { return static_cast<float>(at / std::max(size, 1.0)); };
    return m_camera.rayThrough({2.0f * fraction(position.x(), m_size.width()) - 1.0f,
                                1.0f - 2.0f * fraction(position.y(), m_size.height())},
                               aspect());
}

void Navigation::setPreset(NavigationPreset preset) {
    m_preset = preset;
    Q_EMIT settingsChanged();
}

void Navigation::setOrbitMode(OrbitMode mode) {
    m_orbitMode = mode;
    Q_EMIT settingsChanged();
}

void Navigation::setGlides(bool on) {
    m_glides = on;
    if (!on && m_glide.isRunning()) {
        setCamera(m_glide.goal(), Arrival::AtOnce);
    }
}

void Navigation::takeHold() {
    m_glide.stop();
}

void Navigation::orbit(float yaw, float pitch) {
    switch (m_orbitMode) {
        case OrbitMode::Point:
            m_camera.orbitAbout(m_anchor.value_or(m_camera.pivot()), yaw, pitch);
            break;
        case OrbitMode::Turntable:
            m_camera.orbit(yaw, pitch);
            break;
        case OrbitMode::Fly:
            // The scene moves with the hand here too, so the view turns against it.
            m_camera.look(-yaw, -pitch);
            break;
    }
}

void Navigation::fly(const glm::vec3& step) {
    // Without an eye, going forward is seeing things larger.
    if (m_camera.isOrthographic()) {
        m_camera.fly({step.x, step.y, 0.0f});
        m_camera.zoom(std::exp(-step.z / m_camera.distance()));
    } else {
        m_camera.fly(step);
    }
}

void Navigation::advance(double seconds) {
    if (m_glide.isRunning()) {
        const float radius = m_camera.sceneRadius();
        m_camera = m_glide.advance(seconds);
        m_camera.setSceneRadius(radius);
        Q_EMIT cameraChanged();
    }
    if (m_flyKeys.any()) {
        const float speed = m_camera.distance() * kFlySpeed * (m_flyFast ? kFastFactor : 1.0f);
        fly(m_flyKeys.direction() * (speed * static_cast<float>(seconds)));
        Q_EMIT cameraChanged();
    }
}

void Navigation::setCamera(const Camera& camera, Arrival arrival) {
    const float radius = m_camera.sceneRadius();
    if (arrival == Arrival::Glide && m_glides) {
        m_glide.start(m_camera, camera);
        m_camera.setProjection(camera.projectionKind());
    } else {
        m_glide.stop();
        m_camera = camera;
        m_camera.setSceneRadius(radius);
    }
    Q_EMIT cameraChanged();
}

void Navigation::frame(const Bounds& bounds, Arrival arrival) {
    if (!bounds.empty()) {
        Camera camera = goal();
        camera.frame(bounds, aspect());
        setCamera(camera, arrival);
    }
}

void Navigation::show(StandardView view) {
    // About what is to be seen: the pivot may be beside it.
    const Camera from = goal();
    setCamera(turnedTo(view, from, centreInSight(scene(), from, aspect()).value_or(from.pivot())));
}

void Navigation::setProjection(Projection projection) {
    Camera camera = goal();
    camera.setProjection(projection);
    setCamera(camera, m_glide.isRunning() ? Arrival::Glide : Arrival::AtOnce);
}

void Navigation::recentre(const glm::vec3& point) {
    Camera camera = goal();
    camera.recentre(point);
    setCamera(camera);
}

void Navigation::flyStep(const glm::vec3& step) {
    takeHold();
    fly(step * (kStride * m_camera.distance()));
    Q_EMIT cameraChanged();
}

}  // namespace hitscope
