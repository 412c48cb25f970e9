// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/handles/target_handles.h"

#include <QKeyEvent>
#include <QLineF>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "session/session.h"
#include "viewport/axis_colours.h"
#include "viewport/handles/handle_geometry.h"
#include "viewport/handles/handle_grip.h"
#include "viewport/inspect_tool.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr double kClear = 26.0;      // logical pixels, at least, from the middle to the other grips
constexpr double kLongest = 4000.0;  // logical pixels, of such a line on each side
constexpr double kMargin = 4.0;      // logical pixels, from the text to the picture's edge
constexpr int kArcSides = 16;        // of a quarter of a circle
constexpr float kGuide = 12.0f;      // times the reach: how far a line goes on while it is dragged along
constexpr float kEdgeOn = 0.17f;     // cosine, below which a circle looks like a line: 10 degrees
constexpr double kQuarter = std::numbers::pi / 2.0;

double distanceToSegment(const QPointF& point, const QPointF& from, const QPointF& to) {
    const QPointF way = to - from;
    const double squared = std::max(QPointF::dotProduct(way, way), 1.0e-6);
    const double at = std::clamp(QPointF::dotProduct(point - from, way) / squared, 0.0, 1.0);
    return lengthOf(point - from - at * way);
}

}  // namespace

TargetHandles::TargetHandles(Viewport& viewport, Session& session)
    : QWidget(&viewport),
      m_viewport(viewport),
      m_session(session),
      m_across(new HandleGrip(viewport, QStringLiteral("moveAcross"),
                              tr("Drag to move across the line of sight; Ctrl: round steps"))) {
    setObjectName(QStringLiteral("targetHandles"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    hide();
    const auto connectGrip = [this](HandleGrip& grip, const TargetDrag::Kind& kind) {
        connect(&grip, &HandleGrip::taken, this, [this, &grip, kind] { take(grip, kind); });
        connect(&grip, &HandleGrip::draggedTo, this,
                [this](const QPointF& to, Qt::KeyboardModifiers modifiers) {
                    if (m_drag) {
                        m_drag->dragTo(to, modifiers.testFlag(Qt::ControlModifier));
                        m_viewport.pictures().motion().moved();
                        apply();
                    }
                });
        connect(&grip, &HandleGrip::released, this, &TargetHandles::endDrag);
        connect(&grip, &HandleGrip::cancelled, this, &TargetHandles::cancelDrag);
    };
    connectGrip(*m_across, {});
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const QChar letter = letterOf(axis);
        m_heads[axis] = new HandleGrip(viewport, QStringLiteral("move%1").arg(letter),
                                       tr("Drag to move along %1; Ctrl: round steps").arg(letter));
        m_turns[axis] = new HandleGrip(viewport, QStringLiteral("turn%1").arg(letter),
                                       tr("Drag to turn about %1; Ctrl: in steps of 15°").arg(letter));
        m_heads[axis]->setColour(axisColour(axis));
        m_turns[axis]->setColour(axisColour(axis));
        m_turns[axis]->setHollow();
        connectGrip(*m_heads[axis], {.turns = false, .axis = axis});
        connectGrip(*m_turns[axis], {.turns = true, .axis = axis});
    }
    viewport.installEventFilter(this);
    connect(&viewport.navigation(), &Navigation::cameraChanged, this, &TargetHandles::follow);
    connect(&viewport.pictures(), &PictureFlow::framePainted, this, &TargetHandles::follow);
    connect(&session.targets(), &SessionTargets::changed, this, [this](TargetId id) {
        if (m_drag && m_drag->moves(id) &&
            !m_isApplying) {  // undone, say: what is held is not where it was held
            m_held->letGo();
            finishDrag();
        }
        follow();
    });
    connect(&session.targets(), &SessionTargets::removed, this, &TargetHandles::follow);
    connect(&session.targets(), &SessionTargets::selectedChanged, this, &TargetHandles::follow);
    connect(&session, &Session::sceneReplaced, this, &TargetHandles::follow);
    connect(&viewport.inspectTool(), &InspectTool::toolChanged, this, [this] {
        SessionTargets& targets = m_session.targets();
        if (isOn() && !targets.selected()) {
            if (targets.size() == 1) {
                targets.select(targets.front()->id);
            } else if (!targets.empty()) {
                Q_EMIT said(tr("Click a target to select it."));
            }
        }
        follow();
    });
}

bool TargetHandles::isOn() const {
    return m_viewport.inspectTool().tool() == Tool::Move;
}

/// World; of the selected targets that are visible.
std::optional<glm::vec3> TargetHandles::middle() const {
    if (!isOn()) {
        return std::nullopt;
    }
    Bounds bounds;
    for (const TargetId id : m_session.targets().allSelected()) {
        const Target& target = *m_session.targets().find(id);
        if (target.visible) {
            bounds.add(target.worldBounds());
        }
    }
    if (bounds.empty()) {
        return std::nullopt;
    }
    return m_drag ? m_drag->middle() : bounds.centre();
}

/// All that is dragged is still there.
bool TargetHandles::isWhole() const {
    const std::vector<TargetPlace> places = m_drag->places();
    return std::all_of(places.begin(), places.end(), [this](const TargetPlace& place) {
        return m_session.targets().find(place.id) != nullptr;
    });
}

/// Metres.
float TargetHandles::reachAt(const glm::vec3& middle) const {
    return kHandleReach * pixelAt(m_viewport, middle);
}

glm::vec3 TargetHandles::circlePoint(const glm::vec3& middle, std::size_t axis, double angle) const {
    return middle + kCircleRadius * reachAt(middle) * onCircle(axis, angle);
}

std::optional<TargetHandles::Places> TargetHandles::placesOf(const glm::vec3& middle) const {
    const std::optional<QPointF> at = placeInPicture(m_viewport, middle);
    if (!at || (!m_drag && !QRectF(m_viewport.rect()).contains(*at))) {
        return std::nullopt;
    }
    Places places;
    places.middle = *at;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const auto head = placeInPicture(m_viewport, middle + reachAt(middle) * axisOf(axis));
        places.heads[axis] = head.value_or(*at);
        places.hasHead[axis] = lengthOf(places.heads[axis] - *at) > kClear;
    }
    return places;
}

/// Where the grip of each circle is clear of the lines, and of the grips before it.
void TargetHandles::chooseQuadrants(const glm::vec3& middle, const Places& places) {
    std::vector<QPointF> grips;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        double best = -1.0;
        QPointF bestPlace;
        for (int quadrant = 0; quadrant < 4; ++quadrant) {
            const auto place =
                placeInPicture(m_viewport, circlePoint(middle, axis, (quadrant + 0.5) * kQuarter));
            double clear = place ? std::numeric_limits<double>::max() : -2.0;
            for (std::size_t line = 0; place && line < kAxes; ++line) {
                clear = std::min(clear, distanceToSegment(*place, places.middle, places.heads[line]));
            }
            for (const QPointF& grip : grips) {
                clear = std::min(clear, place ? lengthOf(*place - grip) : clear);
            }
            if (clear > best + 1.0) {  // of equals the first, however numbers are rounded
                best = clear;
                bestPlace = *place;
                m_quadrants[axis] = quadrant;
            }
        }
        grips.push_back(bestPlace);
    }
}

/// Returns whether all of it is before the eye.
bool TargetHandles::placeArc(const glm::vec3& middle, std::size_t axis, Places& places) {
    const bool isTurned = m_drag && m_drag->kind().turns && m_drag->kind().axis == axis;
    const double start = m_quadrants[axis] * kQuarter + (isTurned ? m_drag->turned() : 0.0);
    const int sides = isTurned ? 4 * kArcSides : kArcSides;
    for (int side = 0; side <= sides; ++side) {
        const auto place =
            placeInPicture(m_viewport, circlePoint(middle, axis, start + side * kQuarter / kArcSides));
        if (!place) {
            return false;
        }
        places.arcs[axis].append(*place);
    }
    places.turns[axis] = places.arcs[axis][kArcSides / 2];
    const glm::vec3 sight =
        glm::normalize(m_viewport.camera().isOrthographic() ? m_viewport.camera().forward()
                                                            : middle - m_viewport.camera().eye());
    const bool isOpen = std::abs(glm::dot(sight, axisOf(axis))) > kEdgeOn;
    places.hasTurn[axis] = isTurned || (isOpen && lengthOf(places.turns[axis] - places.middle) > kClear);
    return true;
}

void TargetHandles::follow() {
    const std::optional<glm::vec3> at = middle();
    if (m_drag && (!at || !isWhole())) {  // what was dragged has gone, or is another mesh now
        m_held->letGo();
        finishDrag();
    }
    std::optional<Places> places = at ? placesOf(*at) : std::nullopt;
    if (places && !m_drag) {
        chooseQuadrants(*at, *places);
    }
    for (std::size_t axis = 0; places && axis < kAxes; ++axis) {
        if (!placeArc(*at, axis, *places)) {
            places.reset();
        }
    }
    if (places == m_places && places.has_value() == isVisible()) {
        return;
    }
    m_places = places;
    const bool isThere = places.has_value();
    const auto show = [this](HandleGrip& grip, bool isShown, const QPointF& place) {
        // What is dragged has the eye: the other grips would lie over it.
        grip.setVisible(m_drag ? m_held == &grip : isShown);
        if (isShown) {
            grip.place(place);
        }
    };
    show(*m_across, isThere, isThere ? places->middle : QPointF());
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        show(*m_heads[axis], isThere && places->hasHead[axis], isThere ? places->heads[axis] : QPointF());
        show(*m_turns[axis], isThere && places->hasTurn[axis], isThere ? places->turns[axis] : QPointF());
    }
    setVisible(isThere);
    setGeometry(m_viewport.rect());
    update();
}

bool TargetHandles::eventFilter(QObject*, QEvent* event) {
    if (event->type() == QEvent::Resize) {
        follow();
    }
    if (event->type() == QEvent::KeyPress && m_drag &&
        static_cast<const QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        m_held->letGo();
        cancelDrag();
        return true;
    }
    return false;
}

// Dragging

void TargetHandles::take(HandleGrip& grip, const TargetDrag::Kind& kind) {
    const std::optional<glm::vec3> at = middle();
    if (!at) {
        return;
    }
    m_viewport.setFocus();  // which takes Escape
    m_session.finishUndoStep();
    std::vector<TargetPlace> before;
    const std::vector<TargetId> selected = m_session.targets().allSelected();
    for (const TargetId id : selected) {
        before.push_back({id, m_session.targets().find(id)->transform});
    }
    m_session.simulation().hold(selected);
    m_drag.emplace(m_viewport, std::move(before), *at, grip.centre(), kind);
    m_held = &grip;
    m_places.reset();  // drawn in another way now
    follow();
}

void TargetHandles::apply() {
    // What is too far away to be a number stays where it is.
    m_isApplying = true;
    static_cast<void>(m_session.targets().setTransforms(m_drag->places(), SessionUndo::Merge::WithSameKind));
    m_isApplying = false;
    follow();
}

void TargetHandles::finishDrag() {
    m_drag.reset();
    m_session.simulation().hold({});
    m_session.finishUndoStep();
}

void TargetHandles::endDrag() {
    if (m_drag) {
        finishDrag();
        m_places.reset();
        follow();
    }
}

void TargetHandles::cancelDrag() {
    if (m_drag) {
        m_drag->takeBack();
        apply();
        endDrag();
    }
}

// Drawing

void TargetHandles::paintEvent(QPaintEvent*) {
    if (!m_places) {
        return;
    }
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    // Seen before any surface: dark below light.
    for (const bool isBelow : {true, false}) {
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
            const bool isOther = m_drag && m_drag->kind().axis != axis;
            const QColor colour = isBelow ? palette().color(QPalette::Window) : axisColour(axis);
            painter.setPen(QPen(colour, isBelow ? 4.0 : 2.0));
            if (m_places->hasTurn[axis] && !isOther && !(m_drag && !m_drag->kind().turns)) {
                painter.drawPolyline(m_places->arcs[axis]);
            }
            if (m_places->hasHead[axis] && !isOther && !(m_drag && m_drag->kind().turns)) {
                painter.drawLine(m_places->middle, m_places->heads[axis]);
            }
        }
    }
    if (m_drag) {
        paintDrag(painter);
    }
}

void TargetHandles::paintDrag(QPainter& painter) const {
    if (m_drag->kind().axis < kAxes) {
        painter.setPen(QPen(axisColour(m_drag->kind().axis), 1.0, Qt::DashLine));
        if (m_drag->kind().turns) {
            const int middle = kArcSides / 2;
            const auto start = placeInPicture(
                m_viewport,
                circlePoint(m_drag->middle(), m_drag->kind().axis,
                            m_quadrants[m_drag->kind().axis] * kQuarter + middle * kQuarter / kArcSides));
            painter.drawLine(m_places->middle, start.value_or(m_places->middle));
            painter.drawLine(m_places->middle, m_places->turns[m_drag->kind().axis]);
        } else {
            // As far as it is before the eye; near it the picture has it far away.
            const auto end = [this](float far) {
                const glm::vec3 way = reachAt(m_drag->middle()) * axisOf(m_drag->kind().axis);
                std::optional<QPointF> place;
                for (; !place; far *= 0.5f) {
                    place = placeInPicture(m_viewport, m_drag->middle() + far * way);
                }
                QLineF line(m_places->middle, *place);
                line.setLength(std::min(line.length(), kLongest));
                return line.p2();
            };
            painter.drawLine(end(-kGuide), end(kGuide));
        }
    }
    const QString text = m_drag->text();
    QRectF box = painter.fontMetrics().boundingRect(text);
    box = box.adjusted(-6.0, -3.0, 6.0, 3.0);
    box.moveCenter(m_places->middle + QPointF(0.0, static_cast<double>(kHandleReach) + 1.5 * box.height()));
    box.moveBottom(std::min(box.bottom(), height() - kMargin));
    box.moveTop(std::max(box.top(), kMargin));
    box.moveRight(std::min(box.right(), width() - kMargin));
    box.moveLeft(std::max(box.left(), kMargin));
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Window));
    painter.drawRoundedRect(box, 4.0, 4.0);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(box, Qt::AlignCenter, text);
}

}  // namespace hitscope
