// SPDX-License-Identifier: GPL-3.0-or-later
// Mouse, wheel and keys of the viewport.
#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QWheelEvent>
#include <algorithm>
#include <limits>

#include "viewport/aim.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr float kAimLength = 8.0f;  // how far aiming looks, in camera distances plus scene sizes

}  // namespace

bool Viewport::event(QEvent* event) {
    if (event->type() == QEvent::NativeGesture &&
        m_navigation.gesture(*static_cast<QNativeGestureEvent*>(event))) {
        event->accept();
        return true;
    }
    return QOpenGLWidget::event(event);
}

void Viewport::mousePressEvent(QMouseEvent* event) {
    fireHeldShot();
    m_navigation.press(*event);
    m_pressTime = event->timestamp();
    m_clickCounts = event->button() == Qt::LeftButton && !m_navigation.hasDragged();
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
    m_navigation.move(*event);
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
    m_navigation.release(*event);
    const bool brief = event->timestamp() - m_pressTime <= static_cast<quint64>(kLongestClick);
    if (m_clickCounts && !m_navigation.hasDragged() && brief && event->button() == Qt::LeftButton) {
        if (event->modifiers() == Qt::ControlModifier) {
            selectAt(event->position());
        } else {
            click(event->position());
        }
    }
    m_clickCounts = false;
}

void Viewport::click(const QPointF& position) {
    m_heldShot = m_navigation.rayAt(position);
    m_holdTimer.start();
}

void Viewport::selectAt(const QPointF& position) {
    const auto met = aimedAt(m_navigation.rayAt(position));
    m_session.selectTarget(met ? met->target : TargetId{});
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
    m_navigation.press(*event);  // which stops the camera
    recentre(event->position());
    m_clickCounts = false;
}

std::optional<PhysicsWorld::RayHit> Viewport::aimedAt(const Ray& ray) const {
    const float length = kAimLength * (camera().distance() + m_session.sceneBounds().diagonal());
    const std::optional<ShownRay> shown = shownPart(m_options.cut, ray, length);
    if (shown) {
        const auto met = m_session.physics().castRay(shown->ray.origin, shown->ray.direction, shown->length);
        if (met || !m_options.cut.on) {
            return met;
        }
    }
    // The floor is whole.
    const auto beyond = m_session.physics().castRay(ray.origin, ray.direction, length);
    return beyond && !beyond->target ? beyond : std::nullopt;
}

Ray Viewport::launched(const Ray& ray) const {
    const auto met = aimedAt(ray);
    Ray shot = shotAlong(ray, camera(), met ? std::optional(met->point) : std::nullopt);
    // What is cut away is not in its way.
    if (const auto shown = shownPart(m_options.cut, shot, std::numeric_limits<float>::max())) {
        shot = shown->ray;
    }
    if (met && met->point != shot.origin) {
        shot.direction = launchDirection(shot.origin, met->point, m_session.projectileSettings().speed);
    }
    return shot;
}

void Viewport::shootAlong(const Ray& ray) {
    m_session.shoot(launched(ray));
    Q_EMIT shot(ray);
}

void Viewport::recentre(const QPointF& position) {
    if (const auto met = aimedAt(m_navigation.rayAt(position))) {
        m_navigation.recentre(met->point);
    }
}

void Viewport::wheelEvent(QWheelEvent* event) {
    m_navigation.wheel(*event);
    event->accept();
}

void Viewport::keyPressEvent(QKeyEvent* event) {
    const bool plain = (event->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == Qt::NoModifier;
    if (plain && event->key() == Qt::Key_Space) {
        if (!event->isAutoRepeat()) {
            shootAtCrosshair();
            m_repeatTimer.start();
        }
    } else if (plain && event->key() == Qt::Key_Escape) {
        m_session.selectHit(std::nullopt);
        m_session.selectTarget({});
    } else if (!m_navigation.keyPress(*event)) {
        QOpenGLWidget::keyPressEvent(event);
    }
}

void Viewport::keyReleaseEvent(QKeyEvent* event) {
    if (event->isAutoRepeat()) {
        event->accept();
        return;
    }
    if (event->key() == Qt::Key_Space) {
        m_repeatTimer.stop();
    } else if (!m_navigation.keyRelease(*event)) {
        QOpenGLWidget::keyReleaseEvent(event);
    }
}

void Viewport::focusOutEvent(QFocusEvent* event) {
    m_navigation.releaseKeys();
    m_repeatTimer.stop();
    QOpenGLWidget::focusOutEvent(event);
}

}  // namespace hitscope
