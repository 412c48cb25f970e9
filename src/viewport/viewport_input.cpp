// SPDX-License-Identifier: GPL-3.0-or-later
// Mouse, wheel and keys of the viewport.
#include <QGuiApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QStyleHints>
#include <QWheelEvent>
#include <utility>

#include "session/vertex_selection.h"
#include "viewport/inspect_tool.h"
#include "viewport/viewport.h"

namespace hitscope {

bool Viewport::event(QEvent* event) {
    if (dynamic_cast<QInputEvent*>(event) != nullptr) {
        m_pictures.refiner().inputCame();
    }
    if (event->type() == QEvent::NativeGesture &&
        m_navigation.gesture(*static_cast<QNativeGestureEvent*>(event))) {
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

void Viewport::mousePressEvent(QMouseEvent* event) {
    m_navigation.press(*event);
    m_pressTime = event->timestamp();
    m_pressedAt = event->position();
    const bool mayShoot = event->button() == Qt::LeftButton && !m_navigation.hasDragged();
    const bool mayRecentre = event->button() == Qt::MiddleButton && event->modifiers() == Qt::NoModifier;
    m_clickCounts = mayShoot || mayRecentre;
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
    const int threshold = QGuiApplication::styleHints()->startDragDistance();
    m_clickCounts = m_clickCounts && (event->position() - m_pressedAt).manhattanLength() < threshold;
    m_navigation.move(*event);
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
    m_navigation.release(*event);
    const bool brief = event->timestamp() - m_pressTime <= static_cast<quint64>(kLongestClick);
    if (std::exchange(m_clickCounts, false) && brief) {
        click(*event);
    }
}

void Viewport::click(const QMouseEvent& event) {
    if (event.button() == Qt::MiddleButton) {
        recentre(event.position());
    } else if (event.button() == Qt::LeftButton && event.modifiers() == Qt::ControlModifier) {
        selectAt(event.position());
    } else if (event.button() == Qt::LeftButton &&
               event.modifiers() == (Qt::ControlModifier | Qt::ShiftModifier)) {
        toggleAt(event.position());
    } else if (event.button() == Qt::LeftButton && m_inspect->tool() == Tool::Move) {
        selectAt(event.position());
    } else if (event.button() == Qt::LeftButton && m_inspect->tool() == Tool::Shoot) {
        shootAlong(m_navigation.rayAt(event.position()));
    }
}

void Viewport::selectAt(const QPointF& position) {
    const auto met = m_aiming.met(m_navigation.rayAt(position));
    m_session.targets().select(met ? met->target : TargetId{});
}

void Viewport::toggleAt(const QPointF& position) {
    const auto met = m_aiming.met(m_navigation.rayAt(position));
    if (!met) {
        return;
    }
    std::vector<TargetId> selected = m_session.targets().allSelected();
    if (std::erase(selected, met->target) > 0) {
        const bool isShown = m_session.targets().selected() == met->target;
        const TargetId last = selected.empty() ? TargetId{} : selected.back();
        m_session.targets().select(isShown ? last : m_session.targets().selected(), selected);
    } else {
        m_session.targets().select(met->target, selected);
    }
}

/// The second press of what the desktop calls a double click is one more click.
void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
    mousePressEvent(event);
}

void Viewport::recentre(const QPointF& position) {
    if (const auto met = m_aiming.met(m_navigation.rayAt(position))) {
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
            m_trigger.press();
        }
    } else if (plain && event->key() == Qt::Key_Escape) {
        m_session.hits().select(std::nullopt);
        m_session.selection().clear();
        m_session.targets().select({});
    } else if (!m_navigation.keyPress(*event)) {
        QWidget::keyPressEvent(event);
    }
}

void Viewport::keyReleaseEvent(QKeyEvent* event) {
    if (event->isAutoRepeat()) {
        event->accept();
        return;
    }
    if (event->key() == Qt::Key_Space) {
        m_trigger.release();
    } else if (!m_navigation.keyRelease(*event)) {
        QWidget::keyReleaseEvent(event);
    }
}

void Viewport::focusOutEvent(QFocusEvent* event) {
    m_navigation.releaseKeys();
    m_trigger.release();
    QWidget::focusOutEvent(event);
}

}  // namespace hitscope
