// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/inspect_tool.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <vector>

#include "analysis/hit_at.h"
#include "viewport/outline_overlay.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr int kLookEvery = 4;       // milliseconds
constexpr int kAgainAfter = 80;     // milliseconds: while frames follow each other, not with each of them
constexpr double kLassoStep = 3.0;  // logical pixels between its corners

using Combine = VertexSelection::Combine;

Combine combineOf(Qt::KeyboardModifiers modifiers) {
    return modifiers.testFlag(Qt::ControlModifier) ? Combine::Add
           : modifiers.testFlag(Qt::ShiftModifier) ? Combine::Remove
                                                   : Combine::Replace;
}

QPolygonF rectangle(const QPointF& a, const QPointF& b) {
    return QPolygonF({a, {b.x(), a.y()}, b, {a.x(), b.y()}});
}

/// The same event with the plain left button: what the camera understands as its own.
QMouseEvent plain(const QMouseEvent& event, QEvent::Type type, const QPointF& position) {
    return {type, position, event.globalPosition(), Qt::LeftButton, Qt::LeftButton, Qt::NoModifier};
}

}  // namespace

void selectTargetOf(Session& session, const VertexRef& vertex) {
    if (session.targets().size() > 1) {
        session.targets().select(vertex.target);
    }
}

InspectTool::InspectTool(Viewport& viewport, Session& session)
    : QObject(&viewport),
      m_viewport(viewport),
      m_session(session),
      m_selection(session.selection()),
      m_overlay(new OutlineOverlay(&viewport)) {
    m_arrivalTimer.setInterval(kLookEvery);
    m_againTimer.setInterval(kAgainAfter);
    m_againTimer.setSingleShot(true);
    connect(&m_arrivalTimer, &QTimer::timeout, this, &InspectTool::takeHovered);
    connect(&m_againTimer, &QTimer::timeout, this, &InspectTool::hoverAgain);
    connect(&viewport.pictures(), &PictureFlow::framePainted, this, [this] {
        if (m_inside && m_tool == Tool::Inspect && !m_againTimer.isActive()) {
            m_againTimer.start();
        }
    });
    viewport.installEventFilter(this);
}

InspectTool::~InspectTool() = default;

void InspectTool::setTool(Tool tool) {
    if (tool == m_tool) {
        return;
    }
    m_tool = tool;
    endDrag();
    leave();
    m_viewport.setMouseTracking(true);  // the aim preview and the wipe line need it too
    showCursor();
    Q_EMIT toolChanged();
}

void InspectTool::setOnWipeLine(bool on) {
    if (on != m_isOnWipeLine) {
        m_isOnWipeLine = on;
        showCursor();
    }
}

void InspectTool::showCursor() {
    const bool picks = m_tool == Tool::Inspect || m_tool == Tool::Brush;
    const Qt::CursorShape own = picks ? Qt::CrossCursor : Qt::ArrowCursor;
    m_viewport.setCursor(m_isOnWipeLine ? Qt::SplitHCursor : own);
}

bool InspectTool::eventFilter(QObject* watched, QEvent* event) {
    if (watched != &m_viewport) {
        return false;
    }
    switch (event->type()) {
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonDblClick:
            return press(static_cast<const QMouseEvent&>(*event));
        case QEvent::MouseMove:
            return move(static_cast<const QMouseEvent&>(*event));
        case QEvent::MouseButtonRelease:
            return release(static_cast<const QMouseEvent&>(*event));
        case QEvent::KeyPress:
            return keyPress(static_cast<const QKeyEvent&>(*event));
        case QEvent::Leave:
            leave();
            return false;
        case QEvent::WindowBlocked:
            letGo();
            return false;
        default:
            return false;
    }
}

bool InspectTool::press(const QMouseEvent& event) {
    const bool ours = m_tool == Tool::Inspect || event.modifiers().testFlag(Qt::AltModifier);
    if (event.button() != Qt::LeftButton || !ours || m_drag != Drag::None) {
        return m_drag != Drag::None;  // other buttons wait until the drag is over
    }
    m_drag = Drag::Undecided;
    m_pressedAt = event.position();
    m_pressedWith = event.modifiers();
    return true;
}

bool InspectTool::move(const QMouseEvent& event) {
    if (!event.buttons().testFlag(Qt::LeftButton)) {
        letGo();
    }
    if (m_drag == Drag::None) {
        if (m_tool == Tool::Inspect && event.buttons() == Qt::NoButton) {
            hover(event.position());
        }
        return false;
    }
    if (m_drag == Drag::Undecided &&
        (event.position() - m_pressedAt).manhattanLength() >= QApplication::startDragDistance()) {
        beginDrag(event);
    }
    if (m_drag == Drag::Outline) {
        extendOutline(event.position());
    } else if (m_drag == Drag::Camera) {
        m_viewport.navigation().move(plain(event, QEvent::MouseMove, event.position()));
    }
    return true;
}

void InspectTool::beginDrag(const QMouseEvent& event) {
    leave();
    if (m_pressedWith.testFlag(Qt::AltModifier)) {
        m_drag = Drag::Camera;
        m_viewport.navigation().press(plain(event, QEvent::MouseButtonPress, m_pressedAt));
    } else {
        m_drag = Drag::Outline;
        m_drawn = QPolygonF({m_pressedAt});
    }
}

void InspectTool::extendOutline(const QPointF& to) {
    if (m_outline == Outline::Rectangle) {
        m_drawn = rectangle(m_pressedAt, to);
    } else if ((to - m_drawn.constLast()).manhattanLength() >= kLassoStep) {
        m_drawn.append(to);
    }
    m_overlay->show(m_drawn);
}

void InspectTool::endDrag() {
    m_drag = Drag::None;
    m_drawn.clear();
    m_overlay->show({});
}

bool InspectTool::release(const QMouseEvent& event) {
    if (m_drag == Drag::None || event.button() != Qt::LeftButton) {
        return m_drag != Drag::None;
    }
    if (m_drag == Drag::Undecided) {
        endDrag();
        click(event.position(), m_pressedWith);
    } else {
        letGo();
    }
    return true;
}

/// The drag has come as far as it goes; without one, no click comes of the press.
void InspectTool::letGo() {
    if (m_drag == Drag::None) {
        return;
    }
    const Drag drag = m_drag;
    const QPolygonF drawn = m_drawn;
    endDrag();
    if (drag == Drag::Outline) {
        selectWithin(drawn, combineOf(m_pressedWith));
    } else if (drag == Drag::Camera) {
        m_viewport.navigation().release(
            {QEvent::MouseButtonRelease, {}, {}, Qt::LeftButton, Qt::NoButton, Qt::NoModifier});
    }
}

bool InspectTool::keyPress(const QKeyEvent& event) {
    if (event.key() != Qt::Key_Escape || event.modifiers() != Qt::NoModifier) {
        return false;
    }
    if (m_drag != Drag::Outline) {
        return false;  // the viewport deselects everything
    }
    endDrag();
    return true;
}

void InspectTool::click(const QPointF& position, Qt::KeyboardModifiers modifiers) {
    const Combine combine = combineOf(modifiers);
    const std::optional<VertexRef> vertex = m_viewport.picking().vertexAt(position);
    if (combine == Combine::Replace) {
        m_session.hits().select(vertex ? hitThatMovedMost(m_session, *vertex) : std::nullopt);
    }
    if (combine != Combine::Remove && (vertex || combine == Combine::Replace)) {
        m_selection.setPicked(vertex);
    }
    if (vertex) {
        selectTargetOf(m_session, *vertex);
        m_selection.select(vertex->target, {vertex->vertex}, combine);
    } else if (combine == Combine::Replace) {
        m_selection.select({}, {}, combine);
    }
}

void InspectTool::selectWithin(const QPolygonF& outline, Combine combine) {
    const auto found = m_viewport.picking().changedWithin(outline, m_selectsHidden);
    if (combine == Combine::Replace) {
        // The first one replaces, so that the others see one change less.
        if (found.empty()) {
            m_selection.select({}, {}, Combine::Replace);
            m_selection.setPicked(std::nullopt);
        }
    }
    for (const auto& [target, vertices] : found) {
        m_selection.select(target, vertices, combine);
        combine = combine == Combine::Replace ? Combine::Add : combine;
    }
    if (found.size() == 1) {
        selectTargetOf(m_session, {found.begin()->first, 0});
    }
}

// Hovering

void InspectTool::leave() {
    m_inside = false;
    m_moved = false;
    m_selection.setHovered(std::nullopt);
}

void InspectTool::hover(const QPointF& position) {
    m_cursor = position;
    m_inside = true;
    m_moved = true;
    if (!m_arrivalTimer.isActive()) {
        askForHovered();
    }
}

void InspectTool::hoverAgain() {
    if (m_inside && m_drag == Drag::None && !m_arrivalTimer.isActive()) {
        askForHovered();
    }
}

void InspectTool::askForHovered() {
    m_moved = false;
    if (m_viewport.picking().requestVertexAt(m_cursor)) {
        m_arrivalTimer.start();
    }
}

void InspectTool::takeHovered() {
    const auto answer = m_viewport.picking().requestedVertex();
    if (!answer) {
        return;
    }
    m_arrivalTimer.stop();
    if (!m_inside) {
        return;
    }
    m_selection.setHovered(*answer);
    if (m_moved) {
        askForHovered();
    }
}

}  // namespace hitscope
