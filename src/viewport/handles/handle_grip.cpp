// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/handles/handle_grip.h"

#include <QCoreApplication>
#include <QMouseEvent>
#include <QPainter>

namespace hitscope {

namespace {

constexpr int kGripSize = 18;   // logical pixels across
constexpr double kHole = 2.75;  // logical pixels, its radius

}  // namespace

HandleGrip::HandleGrip(QWidget& over, const QString& name, const QString& toolTip) : QWidget(&over) {
    setObjectName(name);
    setToolTip(toolTip);
    setAccessibleName(toolTip);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    setCursor(Qt::OpenHandCursor);
    setMouseTracking(true);
    resize(kGripSize, kGripSize);
    setMask(QRegion(rect(), QRegion::Ellipse));
    hide();
}

void HandleGrip::place(const QPointF& centre) {
    m_centre = centre;
    move((centre - QPointF(0.5 * kGripSize, 0.5 * kGripSize)).toPoint());
}

void HandleGrip::letGo() {
    if (m_isHeld) {
        m_isHeld = false;
        setCursor(Qt::OpenHandCursor);
        update();
    }
}

void HandleGrip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool isHeld = m_isOver || m_isHeld;
    const QColor highlight = palette().color(isHeld ? QPalette::Highlight : QPalette::WindowText);
    // An axis keeps its colour.
    const QColor edge =
        palette().color(isHeld && m_colour.isValid() ? QPalette::WindowText : QPalette::Window);
    painter.setPen(QPen(edge, 1.5));
    painter.setBrush(m_colour.isValid() ? m_colour : highlight);
    painter.drawEllipse(QRectF(rect()).adjusted(3.0, 3.0, -3.0, -3.0));
    if (m_isHollow) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(palette().color(QPalette::Window));
        painter.drawEllipse(QRectF(rect()).center(), kHole, kHole);
    }
}

void HandleGrip::mousePressEvent(QMouseEvent* event) {
    if (m_isHeld && event->button() == Qt::RightButton) {
        letGo();
        Q_EMIT cancelled();
        return;
    }
    if (event->button() != Qt::LeftButton) {
        event->ignore();
        return;
    }
    m_isHeld = true;
    m_offset = m_centre - parentWidget()->mapFromGlobal(event->globalPosition());
    setCursor(Qt::ClosedHandCursor);
    update();
    Q_EMIT taken();
}

bool HandleGrip::event(QEvent* event) {
    if (event->type() == QEvent::WindowBlocked) {
        release();
    }
    return QWidget::event(event);
}

void HandleGrip::release() {
    if (m_isHeld) {
        letGo();
        Q_EMIT released();
    }
}

void HandleGrip::mouseMoveEvent(QMouseEvent* event) {
    if (!event->buttons().testFlag(Qt::LeftButton)) {
        release();  // another window got the button's
    }
    if (!m_isHeld) {
        event->setAccepted(event->buttons() == Qt::NoButton);  // a drag is the camera's
        return;
    }
    Q_EMIT draggedTo(parentWidget()->mapFromGlobal(event->globalPosition()) + m_offset, event->modifiers());
}

void HandleGrip::mouseReleaseEvent(QMouseEvent* event) {
    if (!m_isHeld || event->button() != Qt::LeftButton) {
        event->ignore();
        return;
    }
    release();
}

void HandleGrip::enterEvent(QEnterEvent*) {
    // The picture under it is not pointed at any more.
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(parentWidget(), &leave);
    m_isOver = true;
    update();
}

void HandleGrip::leaveEvent(QEvent*) {
    m_isOver = false;
    update();
}

}  // namespace hitscope
