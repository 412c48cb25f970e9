// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>
#include <QTimer>
#include <deque>
#include <optional>

#include "deform/hit.h"

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace hitscope {

class OutlineOverlay;
class Session;
class Viewport;

/// How the brush dents.
struct BrushSettings {
    double size = 1.0;           ///< times the constants in force
    double strength = 1.0;       ///< times their power and max magnitude
    double spacing = 0.5;        ///< between two hits of a stroke, times the reach of one
    double spacingMetres = 0.0;  ///< the same, metres; 0: `spacing` says it
    bool isInward = true;        ///< into the surface; else away from the eye

    bool operator==(const BrushSettings&) const = default;

    static constexpr double kLeast = 0.05;  ///< of size, strength and spacing
    static constexpr double kMost = 10.0;   ///< likewise
};

/// Painting hits: with the Brush tool, a drag that begins on a target puts a hit every so far along the
/// surface as it is then, dents and all. What a drag makes is a group, and one step to undo. A drag that
/// begins beside all targets moves the camera.
///
/// [ and ] change the size, with Shift the strength; so does the wheel with Ctrl, and with Ctrl and Shift.
/// Escape takes the stroke back that is being painted. The time that painting takes is cut into slices, so
/// that the window never waits for it.
class BrushTool : public QObject {
    Q_OBJECT
public:
    BrushTool(Viewport& viewport, Session& session);
    ~BrushTool() override;

    [[nodiscard]] const BrushSettings& settings() const { return m_settings; }
    /// Clamped to their ranges.
    void setSettings(const BrushSettings& settings);
    /// A stroke is being painted, or what the mouse drew has not all been.
    [[nodiscard]] bool isPainting() const { return m_stroke.has_value(); }
    void cancelStroke();  ///< isPainting(): takes it back
    /// The constants that a hit of the brush has on a target; of a target that is not there: those in force.
    [[nodiscard]] Hit modelOn(TargetId target) const;
    [[nodiscard]] static float radiusOf(const Hit& hit);

    static constexpr double kPixelsAStep = 2.0;  ///< how closely the surface is looked at along a drag

Q_SIGNALS:
    void settingsChanged();
    void strokeEnded(std::size_t hits);  ///< 0: it was cancelled
    void refused(const hitscope::Error& error);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Stroke {
        HitGroup group;
        std::size_t hits = 0;
        QPointF at;                      ///< logical pixels: how far it has been painted
        std::optional<glm::vec3> under;  ///< metres, world: the surface there, as it is now
        double since = 0.0;              ///< metres along the surface since the last hit
        std::deque<QPointF> ahead;       ///< where the mouse has been since
        bool isReleased = false;
    };

    [[nodiscard]] bool isActive() const;
    bool press(const QMouseEvent& event);
    bool move(const QMouseEvent& event);
    bool release(const QMouseEvent& event);
    void letGo();
    bool keyPress(const QKeyEvent& event);
    bool wheel(const QWheelEvent& event);
    void change(bool strength, double factor);
    void paint();
    bool step();
    std::size_t leaveStroke();
    void endStroke();
    [[nodiscard]] std::optional<Hit> hitAt(const QPointF& position) const;
    [[nodiscard]] std::optional<glm::vec3> surfaceAt(const QPointF& position) const;
    [[nodiscard]] glm::vec3 inwardAt(const Hit& hit) const;
    [[nodiscard]] double spacingOf(const Hit& hit) const;
    void put(const Hit& hit);
    void showRing();
    void hideRing();

    Viewport& m_viewport;
    Session& m_session;
    OutlineOverlay* m_ring;
    BrushSettings m_settings;
    std::optional<Stroke> m_stroke;
    double m_spacing = 0.0;  ///< metres, of the last hit
    QPointF m_cursor;
    bool m_isInside = false;  ///< the cursor is over the viewport
    QTimer m_paintTimer;      ///< to paint on, after other events
    QTimer m_ringTimer;
};

}  // namespace hitscope
