// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/navigation.h"

#include <QGuiApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QStyleHints>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace hitscope {

namespace {

constexpr float kZoomPerNotch = 0.88f;
constexpr double kNotch = 120.0;            // QWheelEvent::angleDelta() of one
constexpr double kPixelsPerNotch = 50.0;    // of trackpads that report pixels only
constexpr float kNotchesPerHeight = 12.0f;  // of a drag that zooms
constexpr float kFlySpeed = 0.7f;           // camera distances a second
constexpr float kFastFactor = 3.0f;         // with Shift
constexpr float kStride = 0.15f;            // camera distances

}  // namespace

Navigation::Navigation(QObject* parent) : QObject(parent) {}

float Navigation::aspect() const {
    return static_cast<float>(std::max(m_size.width(), 1.0) / std::max(m_size.height(), 1.0));
}

Ray Navigation::rayAt(const QPointF& position) const {
    const auto fraction = [](double at, double size) { return static_cast<float>(at / std::max(size, 1.0)); };
    return m_camera.rayThrough({2.0f * fraction(position.x(), m_size.width()) - 1.0f,
                                1.0f - 2.0f * fraction(position.y(), m_size.height())},
                               aspect());
}

void Navigation::press(const QMouseEvent& event) {
    m_pressedAt = event.position();
    m_draggedTo = m_pressedAt;
    m_motion = motionOf(m_preset, event.button(), event.modifiers());
    // Only a press that could be a click waits to see whether it is one.
    const bool mayClick = event.button() == Qt::LeftButton && !event.modifiers().testFlag(Qt::ShiftModifier);
    m_dragged = !mayClick;
}

void Navigation::move(const QMouseEvent& event) {
    if (event.buttons() == Qt::NoButton) {
        return;
    }
    const int threshold = QGuiApplication::styleHints()->startDragDistance();
    m_dragged = m_dragged || (event.position() - m_pressedAt).manhattanLength() >= threshold;
    if (m_dragged && m_motion != CameraMotion::None) {
        drag(event.position() - m_draggedTo);
        m_draggedTo = event.position();
    }
}

void Navigation::release(const QMouseEvent& event) {
    if (event.buttons() == Qt::NoButton) {
        m_motion = CameraMotion::None;
    }
}

void Navigation::drag(const QPointF& delta) {
    const double pixel = 1.0 / std::max(m_size.height(), 1.0);
    const auto x = static_cast<float>(delta.x() * pixel);
    const auto y = static_cast<float>(delta.y() * pixel);
    if (m_motion == CameraMotion::Orbit) {
        m_camera.orbit(-x * glm::pi<float>(), y * glm::pi<float>());
    } else if (m_motion == CameraMotion::Pan) {
        m_camera.pan({x, -y});
    } else {
        m_camera.zoom(std::pow(kZoomPerNotch, -y * kNotchesPerHeight));
    }
    Q_EMIT cameraChanged();
}

void Navigation::wheel(const QWheelEvent& event) {
    double notches = event.angleDelta().y() / kNotch;
    if (notches == 0.0) {
        notches = event.pixelDelta().y() / kPixelsPerNotch;
    }
    if (notches != 0.0) {
        m_camera.zoom(std::pow(kZoomPerNotch, static_cast<float>(notches)));
        Q_EMIT cameraChanged();
    }
}

bool Navigation::keyPress(const QKeyEvent& event) {
    m_flyFast = event.modifiers().testFlag(Qt::ShiftModifier);
    const bool plain = (event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == Qt::NoModifier;
    if (!plain || !m_flyKeys.press(event.key())) {
        return false;
    }
    Q_EMIT cameraChanged();
    return true;
}

bool Navigation::keyRelease(const QKeyEvent& event) {
    m_flyFast = event.modifiers().testFlag(Qt::ShiftModifier);
    return m_flyKeys.release(event.key());
}

void Navigation::advance(double seconds) {
    if (m_flyKeys.any()) {
        const float speed = m_camera.distance() * kFlySpeed * (m_flyFast ? kFastFactor : 1.0f);
        m_camera.fly(m_flyKeys.direction() * (speed * static_cast<float>(seconds)));
    }
}

void Navigation::frame(const Bounds& bounds) {
    if (!bounds.empty()) {
        m_camera.frame(bounds, aspect());
        Q_EMIT cameraChanged();
    }
}

void Navigation::recentre(const glm::vec3& point) {
    m_camera.recentre(point);
    Q_EMIT cameraChanged();
}

void Navigation::flyStep(const glm::vec3& step) {
    m_camera.fly(step * (kStride * m_camera.distance()));
    Q_EMIT cameraChanged();
}

}  // namespace hitscope
