// SPDX-License-Identifier: GPL-3.0-or-later
// What mouse, wheel, trackpad and keys do to the camera.
#include <QGuiApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QStyleHints>
#include <QWheelEvent>
#include <QtMath>
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "viewport/navigation.h"

namespace hitscope {

namespace {

constexpr float kZoomPerNotch = 0.88f;
constexpr float kRadiansPerNotch = 0.07f;   // of field of view: four degrees
constexpr double kNotch = 120.0;            // QWheelEvent::angleDelta() of one
constexpr double kPixelsPerNotch = 50.0;    // of trackpads that report pixels only
constexpr float kNotchesPerHeight = 12.0f;  // of a drag that zooms
constexpr double kPinchLimit = 0.9;         // of one event; a scale has to stay above zero

/// Two fingers on a trackpad, and not a wheel: it says so, or its movement has a beginning and an end.
bool isTrackpad(const QWheelEvent& event) {
    const QPointingDevice* device = event.pointingDevice();
    return event.phase() != Qt::NoScrollPhase ||
           (device != nullptr && device->type() == QInputDevice::DeviceType::TouchPad);
}

}  // namespace

void Navigation::press(const QMouseEvent& event) {
    takeHold();
    m_pressedAt = event.position();
    m_draggedTo = m_pressedAt;
    m_motion = motionOf(m_preset, event.button(), event.modifiers());
    // Only a press that could be a click waits to see whether it is one; a right click opens a menu.
    const bool isShifted =
        event.modifiers().testFlag(Qt::ShiftModifier) && !event.modifiers().testFlag(Qt::ControlModifier);
    const bool mayClick =
        (event.button() == Qt::LeftButton && !isShifted) || event.button() == Qt::RightButton;
    m_dragged = !mayClick;
    m_anchor.reset();
    if (m_motion == CameraMotion::Orbit && m_orbitMode == OrbitMode::Point) {
        m_anchor = anchorAt(m_pressedAt);
    } else if (m_motion == CameraMotion::Zoom) {
        m_anchor = zoomAnchorAt(m_pressedAt);
    }
}

void Navigation::move(const QMouseEvent& event) {
    if (event.buttons() == Qt::NoButton) {
        return;
    }
    const int threshold = QGuiApplication::styleHints()->startDragDistance();
    m_dragged = m_dragged || (event.position() - m_pressedAt).manhattanLength() >= threshold;
    if (m_dragged && m_motion != CameraMotion::None) {
        moveBy(m_motion, event.position() - m_draggedTo);
        m_draggedTo = event.position();
    }
}

void Navigation::release(const QMouseEvent& event) {
    if (event.buttons() == Qt::NoButton) {
        m_motion = CameraMotion::None;
        m_anchor.reset();
    }
}

void Navigation::moveBy(CameraMotion motion, const QPointF& delta) {
    const double pixel = 1.0 / std::max(m_size.height(), 1.0);
    const auto x = static_cast<float>(delta.x() * pixel);
    const auto y = static_cast<float>(delta.y() * pixel);
    if (motion == CameraMotion::Orbit) {
        // Looking around, what is under the cursor stays there; orbiting, a drag over the whole height turns
        // by half a circle.
        const float turn = m_orbitMode == OrbitMode::Fly ? m_camera.fieldOfView() : glm::pi<float>();
        if (m_orbitMode == OrbitMode::Fly) {
            orbit(-x * turn, y * turn);
        } else {
            moveInSight([&](float part) { orbit(-x * turn * part, y * turn * part); });
        }
    } else if (motion == CameraMotion::Pan) {
        // One after the other: it slides along where it cannot go on.
        moveInSight([&](float part) { m_camera.pan({x * part, 0.0f}); });
        moveInSight([&](float part) { m_camera.pan({0.0f, -y * part}); });
    } else {
        zoom(std::pow(kZoomPerNotch, -y * kNotchesPerHeight), m_anchor.value_or(m_camera.pivot()));
    }
    Q_EMIT cameraChanged();
}

void Navigation::turnWheel(float notches, const QPointF& at, bool fieldOfView) {
    // An orthographic view has none to change.
    if (fieldOfView && !m_camera.isOrthographic()) {
        const float before = m_camera.fieldOfView();
        moveInSight([&](float part) { m_camera.setFieldOfView(before - kRadiansPerNotch * notches * part); });
        Q_EMIT fieldOfViewChanged();
    } else {
        zoom(std::pow(kZoomPerNotch, notches), zoomAnchorAt(at));
    }
    Q_EMIT cameraChanged();
}

void Navigation::wheel(const QWheelEvent& event) {
    takeHold();
    if (isTrackpad(event)) {
        QPointF moved = event.pixelDelta();
        if (moved.isNull()) {
            moved = QPointF(event.angleDelta()) * (kPixelsPerNotch / kNotch);
        }
        const CameraMotion motion = trackpadMotion(event.modifiers());
        m_anchor = motion == CameraMotion::Zoom ? zoomAnchorAt(event.position()) : anchorAt(event.position());
        moveBy(motion, moved);
        m_anchor.reset();
        return;
    }
    double notches = event.angleDelta().y() / kNotch;
    if (notches == 0.0) {
        notches = event.pixelDelta().y() / kPixelsPerNotch;
    }
    if (notches != 0.0) {
        turnWheel(static_cast<float>(notches), event.position(),
                  event.modifiers().testFlag(Qt::ShiftModifier));
    }
}

bool Navigation::gesture(const QNativeGestureEvent& event) {
    if (event.gestureType() == Qt::ZoomNativeGesture) {
        takeHold();
        const double scale = 1.0 + std::clamp(event.value(), -kPinchLimit, 1.0 / kPinchLimit);
        zoom(static_cast<float>(1.0 / scale), zoomAnchorAt(event.position()));
    } else if (event.gestureType() == Qt::RotateNativeGesture) {
        takeHold();
        m_anchor = anchorAt(event.position());
        const auto turn = static_cast<float>(qDegreesToRadians(event.value()));
        moveInSight([&](float part) { orbit(turn * part, 0.0f); });
        m_anchor.reset();
    } else {
        return false;
    }
    Q_EMIT cameraChanged();
    return true;
}

bool Navigation::keyPress(const QKeyEvent& event) {
    m_flyFast = event.modifiers().testFlag(Qt::ShiftModifier);
    const bool plain = (event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == Qt::NoModifier;
    if (!plain || !m_flyKeys.press(event.key())) {
        return false;
    }
    takeHold();
    Q_EMIT cameraChanged();
    return true;
}

bool Navigation::keyRelease(const QKeyEvent& event) {
    m_flyFast = event.modifiers().testFlag(Qt::ShiftModifier);
    return m_flyKeys.release(event.key());
}

}  // namespace hitscope
