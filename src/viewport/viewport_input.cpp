// SPDX-License-Identifier: GPL-3.0-or-later
// Mouse, wheel and keys of the viewport.
#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "viewport/aim.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr float kZoomPerNotch = 0.88f;
constexpr double kNotch = 120.0;          // QWheelEvent::angleDelta() of one
constexpr double kPixelsPerNotch = 50.0;  // of trackpads that report pixels only
constexpr float kAimLength = 8.0f;        // how far aiming looks, in camera distances plus scene sizes

}  // namespace

Ray Viewport::rayAt(const QPointF& position) const {
    const auto fraction = [](double at, int size) { return static_cast<float>(at / std::max(size, 1)); };
    return m_camera.rayThrough(
        {2.0f * fraction(position.x(), width()) - 1.0f, 1.0f - 2.0f * fraction(position.y(), height())},
        aspect());
}

void Viewport::mousePressEvent(QMouseEvent* event) {
    fireHeldShot();
    beginDrag(event);
    m_clickCounts = event->button() == Qt::LeftButton && m_drag == Drag::Undecided;
}

void Viewport::beginDrag(QMouseEvent* event) {
    m_pressedAt = event->position();
    m_draggedTo = m_pressedAt;
    m_pressTime = event->timestamp();
    const bool pans = event->button() == Qt::RightButton || event->button() == Qt::MiddleButton ||
                      (event->button() == Qt::LeftButton && event->modifiers().testFlag(Qt::ShiftModifier));
    m_drag = pans ? Drag::Pan : event->button() == Qt::LeftButton ? Drag::Undecided : Drag::None;
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
    if (m_drag == Drag::Undecided &&
        (event->position() - m_pressedAt).manhattanLength() >= QApplication::startDragDistance()) {
        m_drag = Drag::Orbit;
    }
    if (m_drag == Drag::Orbit || m_drag == Drag::Pan) {
        drag(event->position() - m_draggedTo);
        m_draggedTo = event->position();
    }
}

void Viewport::drag(const QPointF& delta) {
    const float pixel = 1.0f / static_cast<float>(std::max(height(), 1));
    const float x = static_cast<float>(delta.x()) * pixel;
    const float y = static_cast<float>(delta.y()) * pixel;
    if (m_drag == Drag::Orbit) {
        m_camera.orbit(-x * glm::pi<float>(), y * glm::pi<float>());
    } else {
        m_camera.pan({x, -y});
    }
    update();
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
    const bool stationary = m_drag == Drag::Undecided;
    if (event->buttons() == Qt::NoButton) {
        m_drag = Drag::None;
    }
    const bool brief = event->timestamp() - m_pressTime <= static_cast<quint64>(kLongestClick);
    if (m_clickCounts && stationary && brief && event->button() == Qt::LeftButton) {
        click(event->position());
    }
    m_clickCounts = false;
}

void Viewport::click(const QPointF& position) {
    m_heldShot = rayAt(position);
    m_holdTimer.start();
}

void Viewport::fireHeldShot() {
    m_holdTimer.stop();
    if (m_heldShot) {
        const Ray ray = *m_heldShot;
        m_heldShot.reset();
        shootAlong(ray);
    }
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
    // The second press of what the desktop calls a double click. Later than our grace the first shot is on
    // its way already, so this is one more click: two shots, and the view stays.
    if (event->button() != Qt::LeftButton || !m_heldShot || event->modifiers() != Qt::NoModifier) {
        mousePressEvent(event);
        return;
    }
    m_heldShot.reset();
    m_holdTimer.stop();
    recentre(event->position());
    beginDrag(event);
    m_clickCounts = false;
}

std::optional<PhysicsWorld::RayHit> Viewport::aimedAt(const Ray& ray) const {
    const float length = kAimLength * (m_camera.distance() + m_session.sceneBounds().diagonal());
    return m_session.physics().castRay(ray.origin, ray.direction, length);
}

void Viewport::shootAlong(const Ray& ray) {
    Ray shot = ray;
    if (const auto met = aimedAt(ray); met && met->point != ray.origin) {
        shot.direction = launchDirection(ray.origin, met->point, m_session.projectileSettings().speed);
    }
    m_session.shoot(shot);
}

void Viewport::recentre(const QPointF& position) {
    if (const auto met = aimedAt(rayAt(position))) {
        m_camera.recentre(met->point);
        update();
    }
}

void Viewport::wheelEvent(QWheelEvent* event) {
    double notches = event->angleDelta().y() / kNotch;
    if (notches == 0.0) {
        notches = event->pixelDelta().y() / kPixelsPerNotch;
    }
    if (notches != 0.0) {
        m_camera.zoom(std::pow(kZoomPerNotch, static_cast<float>(notches)));
        update();
    }
    event->accept();
}

void Viewport::keyPressEvent(QKeyEvent* event) {
    const bool plain = (event->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == Qt::NoModifier;
    m_flyFast = event->modifiers().testFlag(Qt::ShiftModifier);
    if (plain && event->key() == Qt::Key_Space) {
        if (!event->isAutoRepeat()) {
            shootAtCrosshair();
            m_repeatTimer.start();
        }
    } else if (plain && event->key() == Qt::Key_Escape) {
        m_session.selectHit(std::nullopt);
        m_session.selectTarget({});
    } else if (plain && m_flyKeys.press(event->key())) {
        update();
    } else {
        QOpenGLWidget::keyPressEvent(event);
    }
}

void Viewport::keyReleaseEvent(QKeyEvent* event) {
    m_flyFast = event->modifiers().testFlag(Qt::ShiftModifier);
    if (event->isAutoRepeat()) {
        event->accept();
        return;
    }
    if (event->key() == Qt::Key_Space) {
        m_repeatTimer.stop();
    } else if (!m_flyKeys.release(event->key())) {
        QOpenGLWidget::keyReleaseEvent(event);
    }
}

void Viewport::focusOutEvent(QFocusEvent* event) {
    m_flyKeys.clear();
    m_repeatTimer.stop();
    QOpenGLWidget::focusOutEvent(event);
}

}  // namespace hitscope
