// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/brush_tool.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "session/paced_advance.h"
#include "session/session.h"
#include "viewport/handles/handle_geometry.h"
#include "viewport/inspect_tool.h"
#include "viewport/outline_overlay.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr double kSlice = 0.006;  // seconds of painting between other events
constexpr int kRingEvery = 16;    // milliseconds
constexpr double kAKey = 1.15;    // by how much a key or a notch changes the size
constexpr int kRingSides = 48;
constexpr double kWheelNotch = 120.0;  // QWheelEvent::angleDelta() of one

}  // namespace

BrushTool::BrushTool(Viewport& viewport, Session& session)
    : QObject(&viewport), m_viewport(viewport), m_session(session), m_ring(new OutlineOverlay(&viewport)) {
    m_ring->setObjectName(QStringLiteral("brushRing"));
    m_paintTimer.setSingleShot(true);
    m_ringTimer.setSingleShot(true);
    m_ringTimer.setInterval(kRingEvery);
    connect(&m_paintTimer, &QTimer::timeout, this, &BrushTool::paint);
    connect(&m_ringTimer, &QTimer::timeout, this, &BrushTool::showRing);
    const auto ringLater = [this] {
        if (isActive() && m_isInside && !m_ringTimer.isActive()) {
            m_ringTimer.start();
        }
    };
    connect(this, &BrushTool::settingsChanged, this, ringLater);
    connect(&viewport.navigation(), &Navigation::cameraChanged, this, ringLater);
    connect(&session.settings(), &SessionSettings::constantsChanged, this, ringLater);
    connect(&session.readBack(), &ReadBack::meshChanged, this, ringLater);
    connect(&viewport.inspectTool(), &InspectTool::toolChanged, this, [this] {
        endStroke();
        hideRing();
    });
    connect(&session, &Session::sceneReplaced, this, [this] {
        m_stroke.reset();
        hideRing();
    });
    viewport.installEventFilter(this);
}

BrushTool::~BrushTool() = default;

bool BrushTool::isActive() const {
    return m_viewport.inspectTool().tool() == Tool::Brush;
}

void BrushTool::setSettings(const BrushSettings& settings) {
    BrushSettings clamped = settings;
    for (double* value : {&clamped.size, &clamped.strength, &clamped.spacing}) {
        *value = std::clamp(*value, BrushSettings::kLeast, BrushSettings::kMost);
    }
    clamped.spacingMetres = std::max(0.0, clamped.spacingMetres);
    if (clamped != m_settings) {
        m_settings = clamped;
        Q_EMIT settingsChanged();
    }
}

bool BrushTool::eventFilter(QObject* watched, QEvent* event) {
    if (watched != &m_viewport || !isActive()) {
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
        case QEvent::Wheel:
            return wheel(static_cast<const QWheelEvent&>(*event));
        case QEvent::Leave:
            m_isInside = false;
            hideRing();
            return false;
        case QEvent::WindowBlocked:
            letGo();
            return false;
        default:
            return false;
    }
}

/// The mouse draws no more of the stroke.
void BrushTool::letGo() {
    if (m_stroke && !m_stroke->isReleased) {
        m_stroke->isReleased = true;
        m_paintTimer.start();
    }
}

bool BrushTool::press(const QMouseEvent& event) {
    if (m_stroke && !m_stroke->isReleased) {
        return true;  // other buttons wait until the stroke is over
    }
    if (event.button() != Qt::LeftButton || event.modifiers() != Qt::NoModifier) {
        return false;
    }
    endStroke();
    const auto met = m_viewport.aiming().met(m_viewport.navigation().rayAt(event.position()));
    if (!met || !met->target) {
        return false;  // the camera's
    }
    m_stroke = Stroke{};  // Clang knows too little of a class within another for emplace()
    m_stroke->group = m_session.hits().newGroup(HitGroupKind::Stroke);
    m_stroke->at = event.position();
    m_stroke->since = std::numeric_limits<double>::infinity();
    m_stroke->ahead.push_back(event.position());
    m_session.finishUndoStep();
    paint();
    return true;
}

bool BrushTool::move(const QMouseEvent& event) {
    m_cursor = event.position();
    m_isInside = true;
    if (!m_ringTimer.isActive()) {
        m_ringTimer.start();
    }
    if (!event.buttons().testFlag(Qt::LeftButton)) {
        letGo();  // another window got the release
    }
    if (!m_stroke || m_stroke->isReleased) {
        return false;
    }
    m_stroke->ahead.push_back(event.position());
    if (!m_paintTimer.isActive()) {
        m_paintTimer.start();
    }
    return true;
}

bool BrushTool::release(const QMouseEvent& event) {
    if (!m_stroke || m_stroke->isReleased) {
        return false;
    }
    if (event.button() == Qt::LeftButton) {
        letGo();
    }
    return true;
}

bool BrushTool::keyPress(const QKeyEvent& event) {
    const Qt::KeyboardModifiers held = event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier);
    if (event.key() == Qt::Key_Escape && m_stroke) {
        cancelStroke();
        return true;
    }
    // Where brackets need AltGr, that is no modifier of ours.
    if ((held & ~Qt::GroupSwitchModifier) != Qt::NoModifier) {
        return false;
    }
    const bool isShifted = event.modifiers().testFlag(Qt::ShiftModifier);
    switch (event.key()) {
        case Qt::Key_BracketLeft:
        case Qt::Key_BraceLeft:
            change(isShifted, 1.0 / kAKey);
            return true;
        case Qt::Key_BracketRight:
        case Qt::Key_BraceRight:
            change(isShifted, kAKey);
            return true;
        default:
            return false;
    }
}

bool BrushTool::wheel(const QWheelEvent& event) {
    if (!event.modifiers().testFlag(Qt::ControlModifier) || event.angleDelta().isNull()) {
        return false;
    }
    // With Shift or Alt some desktops turn the wheel by 90 degrees.
    const int turned = event.angleDelta().y() != 0 ? event.angleDelta().y() : event.angleDelta().x();
    change(event.modifiers().testFlag(Qt::ShiftModifier), std::pow(kAKey, turned / kWheelNotch));
    return true;
}

void BrushTool::change(bool strength, double factor) {
    BrushSettings settings = m_settings;
    (strength ? settings.strength : settings.size) *= factor;
    setSettings(settings);
}

// Painting

void BrushTool::put(const Hit& hit) {
    m_spacing = spacingOf(hit);
    if (const Status added = m_session.hits().extendStroke(m_stroke->group, hit); !added) {
        Q_EMIT refused(added.error());
        return;
    }
    ++m_stroke->hits;
}

/// Paints on for a slice of time, and the rest after other events.
void BrushTool::paint() {
    if (!m_stroke) {
        return;
    }
    const std::function<bool()> isTimeUp = timeLimit(kSlice);
    do {
        // What is painted is struck by the next hit.
        if (!m_session.simulation().updateColliders(isTimeUp)) {
            m_paintTimer.start();
            return;
        }
        if (!m_stroke || !step()) {
            break;
        }
    } while (!isTimeUp());
    if (!m_stroke) {
        return;
    }
    if (!m_stroke->ahead.empty()) {
        m_paintTimer.start();
    } else if (m_stroke->isReleased) {
        endStroke();
    }
}

/// One step along the drag, and a hit where one is due. Returns whether there is more.
bool BrushTool::step() {
    Stroke& stroke = *m_stroke;
    if (stroke.ahead.empty()) {
        return false;
    }
    const QPointF way = stroke.ahead.front() - stroke.at;
    const double length = lengthOf(way);
    const bool isThere = length <= kPixelsAStep;
    const QPointF next = isThere ? stroke.ahead.front() : stroke.at + way * (kPixelsAStep / length);
    if (isThere) {
        stroke.ahead.pop_front();
    }
    stroke.at = next;
    // How far it is along the surface as it is before the next hit: a dent that was just made would add its
    // depth. Where the drag was beside all targets a hit is due at once.
    const std::optional<glm::vec3> under = surfaceAt(next);
    stroke.since += under && stroke.under ? static_cast<double>(glm::distance(*under, *stroke.under))
                    : under               ? std::numeric_limits<double>::infinity()
                                          : 0.0;
    stroke.under = under;
    if (under && stroke.since >= m_spacing) {
        if (const std::optional<Hit> hit = hitAt(next)) {
            stroke.since = 0.0;
            put(*hit);
            m_session.simulation().updateColliders(timeLimit(kSlice));
            if (m_stroke) {
                m_stroke->under = surfaceAt(next);
            }
        }
    }
    return m_stroke && !m_stroke->ahead.empty();
}

/// Returns the hits of the stroke.
std::size_t BrushTool::leaveStroke() {
    const std::size_t hits = m_stroke->hits;
    m_stroke.reset();
    m_paintTimer.stop();
    m_session.finishUndoStep();
    return hits;
}

void BrushTool::endStroke() {
    if (m_stroke) {
        const std::size_t hits = leaveStroke();
        if (hits > 0) {
            Q_EMIT strokeEnded(hits);
        }
    }
}

void BrushTool::cancelStroke() {
    const HitGroup group = m_stroke->group;
    const std::size_t hits = leaveStroke();
    const std::span<const Hit> all = m_session.hits().history().hits();
    if (hits > 0 && !all.empty() && all.back().group == group) {
        m_session.undo();
    }
    Q_EMIT strokeEnded(0);
}

// The ring

void BrushTool::showRing() {
    const auto met = isActive() && m_isInside
                         ? m_viewport.aiming().met(m_viewport.navigation().rayAt(m_cursor))
                         : std::nullopt;
    if (!met || !met->target) {
        hideRing();
        return;
    }
    const glm::vec3 other =
        std::abs(met->normal.y) > 0.9f ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
    const glm::vec3 right = radiusOf(modelOn(met->target)) * glm::normalize(glm::cross(other, met->normal));
    const glm::vec3 up = glm::cross(met->normal, right);
    QPolygonF ring;
    for (int side = 0; side < kRingSides; ++side) {
        const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(side) / kRingSides;
        if (const auto place =
                placeInPicture(m_viewport, met->point + std::cos(angle) * right + std::sin(angle) * up)) {
            ring.append(*place);
        }
    }
    m_ring->show(ring);
}

void BrushTool::hideRing() {
    m_ring->show({});
}

}  // namespace hitscope
