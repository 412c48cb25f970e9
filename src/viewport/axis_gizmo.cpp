// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/axis_gizmo.h"

#include <QAction>
#include <QApplication>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <glm/geometric.hpp>

#include "viewport/axis_colours.h"
#include "viewport/navigation.h"

namespace hitscope {

namespace {

constexpr int kMargin = 8;       // logical pixels, to the view's corner
constexpr double kReach = 34.0;  // logical pixels, from the middle to an end seen from the side
constexpr double kEnd = 9.5;     // logical pixels, an end's radius
constexpr double kBack = 0.55;   // opacity of the disc while the cursor is over it

/// From the origin to where the eye of that view is.
glm::vec3 axisOf(StandardView view) {
    switch (view) {
        case StandardView::Front:
            return {0, 0, 1};
        case StandardView::Back:
            return {0, 0, -1};
        case StandardView::Right:
            return {1, 0, 0};
        case StandardView::Left:
            return {-1, 0, 0};
        case StandardView::Top:
            return {0, 1, 0};
        case StandardView::Bottom:
            break;
    }
    return {0, -1, 0};
}

StandardView opposite(StandardView view) {
    const auto number = static_cast<int>(view);  // they come in pairs
    return static_cast<StandardView>(number % 2 == 0 ? number + 1 : number - 1);
}

bool isPositive(StandardView view) {
    return static_cast<int>(view) % 2 == 0;
}

QString letterOf(StandardView view) {
    const glm::vec3 axis = axisOf(view);
    const QString letter = QStringLiteral("%1").arg(QLatin1Char(axis.x != 0 ? 'X' : axis.y != 0 ? 'Y' : 'Z'));
    return isPositive(view) ? letter : QChar(0x2212) + letter;
}

QColor colourOf(StandardView view) {
    const glm::vec3 axis = axisOf(view);
    return axisColour(axis.x != 0 ? 0 : axis.y != 0 ? 1 : 2);
}

}  // namespace

AxisGizmo::AxisGizmo(Navigation& navigation, QWidget* over) : QWidget(over), m_navigation(navigation) {
    setObjectName(QStringLiteral("axisGizmo"));
    setFixedSize(kSide, kSide);
    setMask(QRegion(0, 0, kSide, kSide, QRegion::Ellipse));
    setMouseTracking(true);
    setCursor(Qt::ArrowCursor);
    setFocusPolicy(Qt::NoFocus);
    over->installEventFilter(this);
    connect(&navigation, &Navigation::cameraChanged, this, qOverload<>(&QWidget::update));
    setToolTip(tr("Click an axis to look along it; drag to orbit"));
    place();
}

void AxisGizmo::setAction(StandardView view, QAction* action) {
    m_actions[static_cast<std::size_t>(view)] = action;
}

bool AxisGizmo::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parent() && event->type() == QEvent::Resize) {
        place();
    }
    return QWidget::eventFilter(watched, event);
}

void AxisGizmo::place() {
    move(parentWidget()->width() - width() - kMargin, kMargin);
}

QPointF AxisGizmo::endOf(StandardView view) const {
    const Camera& camera = m_navigation.camera();
    const glm::vec3 axis = axisOf(view);
    const double middle = 0.5 * kSide;
    return {middle + kReach * static_cast<double>(glm::dot(axis, camera.right())),
            middle - kReach * static_cast<double>(glm::dot(axis, camera.up()))};
}

std::array<StandardView, 6> AxisGizmo::byDepth() const {
    std::array<StandardView, 6> views = kStandardViews;
    const glm::vec3 forward = m_navigation.camera().forward();
    std::stable_sort(views.begin(), views.end(), [&forward](StandardView a, StandardView b) {
        return glm::dot(axisOf(a), forward) > glm::dot(axisOf(b), forward);
    });
    return views;
}

std::optional<StandardView> AxisGizmo::endAt(const QPointF& at) const {
    const std::array<StandardView, 6> views = byDepth();
    const auto found = std::find_if(views.rbegin(), views.rend(), [&](StandardView view) {
        const QPointF away = at - endOf(view);
        return QPointF::dotProduct(away, away) <= kEnd * kEnd;
    });
    return found == views.rend() ? std::nullopt : std::optional(*found);
}

void AxisGizmo::paintEnd(QPainter& painter, StandardView view) const {
    const QPointF end = endOf(view);
    const bool isHovered = m_hovered == view;
    const QColor colour = isHovered ? colourOf(view).lighter(125) : colourOf(view);
    if (isPositive(view)) {
        painter.setPen(QPen(colour, 2.5, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(QPointF(0.5 * kSide, 0.5 * kSide), end);
        painter.setBrush(colour);
    } else {
        QColor fill = colour;
        fill.setAlphaF(isHovered ? 0.9f : 0.3f);
        painter.setBrush(fill);
    }
    painter.setPen(QPen(isHovered ? palette().color(QPalette::WindowText) : colour, 1.5));
    painter.drawEllipse(end, kEnd - 1.0, kEnd - 1.0);
    if (isPositive(view) || isHovered) {
        painter.setPen(Qt::white);
        painter.drawText(QRectF(end - QPointF(kEnd, kEnd), end + QPointF(kEnd, kEnd)), Qt::AlignCenter,
                         letterOf(view));
    }
}

void AxisGizmo::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_pressed || underMouse()) {
        QColor back = palette().color(QPalette::Window);
        back.setAlphaF(static_cast<float>(kBack));
        painter.setPen(Qt::NoPen);
        painter.setBrush(back);
        painter.drawEllipse(QRectF(rect()).adjusted(1, 1, -1, -1));
    }
    QFont letters = font();
    letters.setBold(true);
    letters.setPixelSize(11);
    painter.setFont(letters);
    for (const StandardView view : byDepth()) {
        paintEnd(painter, view);
    }
}

void AxisGizmo::click(StandardView view) {
    const bool isThere = standardViewOf(m_navigation.goal()) == view;
    const StandardView wanted = isThere ? opposite(view) : view;
    if (QAction* action = m_actions[static_cast<std::size_t>(wanted)]) {
        action->trigger();
    } else {
        m_navigation.show(wanted);
    }
}

void AxisGizmo::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) {
        event->ignore();
        return;
    }
    m_pressed = true;
    m_dragged = false;
    m_pressedAt = event->position();
    m_draggedTo = m_pressedAt;
}

void AxisGizmo::mouseMoveEvent(QMouseEvent* event) {
    if (!m_pressed) {
        hover(event->position());
        event->setAccepted(event->buttons() == Qt::NoButton);
        return;
    }
    m_dragged =
        m_dragged || (event->position() - m_pressedAt).manhattanLength() >= QApplication::startDragDistance();
    if (m_dragged) {
        m_navigation.turnBy(event->position() - m_draggedTo);
        m_draggedTo = event->position();
    }
}

void AxisGizmo::mouseReleaseEvent(QMouseEvent* event) {
    if (!m_pressed || event->button() != Qt::LeftButton) {
        event->ignore();
        return;
    }
    m_pressed = false;
    const auto pressed = endAt(m_pressedAt);
    if (!m_dragged && pressed && endAt(event->position()) == pressed) {
        click(*pressed);
    }
    hover(event->position());
}

void AxisGizmo::hover(const QPointF& at) {
    const auto found = endAt(at);
    if (found != m_hovered) {
        m_hovered = found;
        setCursor(found ? Qt::PointingHandCursor : Qt::ArrowCursor);
        update();
    }
}

void AxisGizmo::enterEvent(QEnterEvent* event) {
    QWidget::enterEvent(event);
    // What the view shows under the cursor is no longer what a click means.
    QEvent left(QEvent::Leave);
    QCoreApplication::sendEvent(parentWidget(), &left);
    update();
}

void AxisGizmo::leaveEvent(QEvent* event) {
    QWidget::leaveEvent(event);
    m_hovered.reset();
    update();
}

}  // namespace hitscope
