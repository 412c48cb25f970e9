// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/handles/cut_handle.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "view/change_options.h"
#include "viewport/handles/handle_geometry.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr int kSize = 34;          // logical pixels across
constexpr double kArrow = 12.0;    // logical pixels from the middle to a tip
constexpr double kHead = 4.5;      // logical pixels
constexpr int kRoundOffsets = 60;  // at most, across the scene

QPolygonF headOf(const QPointF& tip, const QPointF& along) {
    const QPointF across(-along.y(), along.x());
    return QPolygonF(
        {tip, tip - kHead * along + 0.7 * kHead * across, tip - kHead * along - 0.7 * kHead * across});
}

}  // namespace

CutHandle::CutHandle(Viewport& viewport) : QWidget(&viewport), m_viewport(viewport) {
    setObjectName(QStringLiteral("cutHandle"));
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    setCursor(Qt::OpenHandCursor);
    setMouseTracking(true);
    setToolTip(tr("Drag to move the cutting plane; Ctrl: round offsets"));
    resize(kSize, kSize);
    setMask(QRegion(rect(), QRegion::Ellipse));
    hide();
    viewport.installEventFilter(this);
    connect(&viewport.navigation(), &Navigation::cameraChanged, this, &CutHandle::follow);
}

void CutHandle::setBounds(const Bounds& bounds) {
    m_bounds = bounds;
    follow();
}

glm::vec3 CutHandle::middle() const {
    return planeFrame(m_viewport.options().cut, m_bounds).middle;
}

void CutHandle::follow() {
    const CuttingPlane& cut = m_viewport.options().cut;
    if (!cut.on || m_bounds.empty()) {
        endDrag();
        hide();
        return;
    }
    const glm::vec3 at = middle();
    const std::optional<QPointF> place = placeInPicture(m_viewport, at);
    const std::optional<QPointF> tip =
        placeInPicture(m_viewport, at + 0.05f * m_bounds.diagonal() * cut.openSide());
    setVisible(place.has_value());
    if (!place) {
        return;
    }
    const QPointF way = tip.value_or(*place) - *place;
    const double length = lengthOf(way);
    const bool isAlong = std::abs(glm::dot(cut.normal, m_viewport.camera().forward())) > kAlongSight;
    m_arrow = isAlong || length < 1.0 ? QPointF() : way / length;
    // Out of the picture it waits at the edge.
    const QPointF corner(
        std::clamp(place->x() - 0.5 * kSize, 0.0, std::max(0.0, m_viewport.width() - 1.0 * kSize)),
        std::clamp(place->y() - 0.5 * kSize, 0.0, std::max(0.0, m_viewport.height() - 1.0 * kSize)));
    move(corner.toPoint());
    update();
}

bool CutHandle::eventFilter(QObject*, QEvent* event) {
    if (event->type() == QEvent::Resize) {
        follow();
    }
    if (event->type() == QEvent::KeyPress && m_drag &&
        static_cast<const QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        cancelDrag();
        return true;
    }
    return false;
}

void CutHandle::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool isHeld = m_over || m_drag.has_value();
    QColor behind = palette().color(QPalette::Window);
    behind.setAlphaF(isHeld ? 0.92f : 0.72f);
    const QColor line = palette().color(isHeld ? QPalette::Highlight : QPalette::WindowText);
    painter.setPen(QPen(line, isHeld ? 2.0 : 1.2));
    painter.setBrush(behind);
    painter.drawEllipse(QRectF(rect()).adjusted(1.5, 1.5, -1.5, -1.5));
    painter.setBrush(line);
    const QPointF middle = QRectF(rect()).center();
    if (m_arrow.isNull()) {
        painter.setPen(Qt::NoPen);
        painter.drawEllipse(middle, 3.5, 3.5);
        return;
    }
    const QPointF reach = (kArrow - 1.0) * m_arrow;
    painter.setPen(QPen(line, 1.8));
    painter.drawLine(middle - reach, middle + reach);
    painter.setPen(Qt::NoPen);
    painter.drawPolygon(headOf(middle + kArrow * m_arrow, m_arrow));
    painter.drawPolygon(headOf(middle - kArrow * m_arrow, -m_arrow));
}

void CutHandle::mousePressEvent(QMouseEvent* event) {
    if (m_drag && event->button() == Qt::RightButton) {
        cancelDrag();
        return;
    }
    if (event->button() != Qt::LeftButton) {
        event->ignore();
        return;
    }
    const CuttingPlane& cut = m_viewport.options().cut;
    m_drag = Drag{cut.offset, mapToParent(event->position().toPoint()), middle(), m_arrow.isNull()};
    setCursor(Qt::ClosedHandCursor);
    update();
}

float CutHandle::moved(const Drag& drag, const QPointF& to) const {
    const CuttingPlane& cut = m_viewport.options().cut;
    const Camera& camera = m_viewport.camera();
    if (drag.isAlongSight) {
        const float up = static_cast<float>(drag.from.y() - to.y()) * pixelAt(m_viewport, drag.middle);
        return glm::dot(cut.normal, camera.forward()) > 0.0f ? up : -up;
    }
    const Navigation& navigation = m_viewport.navigation();
    const float from = nearestAlong(navigation.rayInFirst(drag.from), drag.middle, cut.normal);
    return nearestAlong(navigation.rayInFirst(to), drag.middle, cut.normal) - from;
}

bool CutHandle::event(QEvent* event) {
    if (event->type() == QEvent::WindowBlocked) {
        endDrag();
    }
    return QWidget::event(event);
}

void CutHandle::mouseMoveEvent(QMouseEvent* event) {
    if (!event->buttons().testFlag(Qt::LeftButton)) {
        endDrag();  // another window got the release
    }
    if (!m_drag) {
        event->setAccepted(event->buttons() == Qt::NoButton);  // a drag is the camera's
        return;
    }
    const OffsetRange range = offsetRange(m_bounds, m_viewport.options().cut.normal);
    float offset = m_drag->offset + moved(*m_drag, mapToParent(event->position().toPoint()));
    if (event->modifiers().testFlag(Qt::ControlModifier)) {
        const double step =
            niceStep(static_cast<double>(range.low), static_cast<double>(range.high), kRoundOffsets);
        offset = static_cast<float>(step * std::round(static_cast<double>(offset) / step));
    }
    if (std::isfinite(offset)) {
        Q_EMIT dragged(std::clamp(offset, range.low, range.high));
    }
}

void CutHandle::mouseReleaseEvent(QMouseEvent* event) {
    if (m_drag && event->button() == Qt::LeftButton) {
        endDrag();
    } else {
        event->ignore();
    }
}

void CutHandle::endDrag() {
    if (m_drag) {
        m_drag.reset();
        setCursor(Qt::OpenHandCursor);
        m_over = rect().contains(mapFromGlobal(QCursor::pos()));
        Q_EMIT hovered(m_over);
        Q_EMIT released();
        update();
    }
}

void CutHandle::cancelDrag() {
    Q_EMIT dragged(m_drag->offset);
    endDrag();
}

void CutHandle::enterEvent(QEnterEvent*) {
    // The picture under it is not pointed at any more.
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&m_viewport, &leave);
    m_over = true;
    Q_EMIT hovered(true);
    update();
}

void CutHandle::leaveEvent(QEvent*) {
    m_over = false;
    Q_EMIT hovered(isDragging());
    update();
}

}  // namespace hitscope
