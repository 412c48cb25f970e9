// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPolygonF>
#include <QWidget>
#include <array>
#include <glm/vec3.hpp>
#include <optional>

#include "viewport/handles/target_drag.h"

namespace hitscope {

class HandleGrip;
class Session;
class Viewport;

/// The selected targets in the picture, to be moved and turned by hand; there while the tool is Move. They
/// are as large in every picture, about the middle of what is selected: a line along each of the world's axes
/// has a grip that moves along it, a quarter of a circle about each axis one that turns about it, and the
/// grip in the middle moves across the line of sight. All of them turn about the middle. Ctrl keeps to round
/// steps. A drag is one step to undo; Escape or the right button takes it back.
class TargetHandles : public QWidget {
    Q_OBJECT
public:
    /// Both outlive this.
    TargetHandles(Viewport& viewport, Session& session);

    /// To where the camera has the selected targets.
    void follow();

Q_SIGNALS:
    void said(const QString& text);  ///< why there are none

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    template <class Value>
    using OfAxes = std::array<Value, kAxes>;

    /// Logical pixels of the viewport.
    struct Places {
        QPointF middle;
        OfAxes<QPointF> heads;
        OfAxes<bool> hasHead;  ///< seen along it, a line has no length
        OfAxes<QPolygonF> arcs;
        OfAxes<QPointF> turns;  ///< the grips on them
        OfAxes<bool> hasTurn;

        bool operator==(const Places&) const = default;
    };
    [[nodiscard]] bool isOn() const;
    [[nodiscard]] bool isWhole() const;
    [[nodiscard]] std::optional<glm::vec3> middle() const;
    [[nodiscard]] float reachAt(const glm::vec3& middle) const;
    [[nodiscard]] std::optional<Places> placesOf(const glm::vec3& middle) const;
    bool placeArc(const glm::vec3& middle, std::size_t axis, Places& places);
    void chooseQuadrants(const glm::vec3& middle, const Places& places);
    [[nodiscard]] glm::vec3 circlePoint(const glm::vec3& middle, std::size_t axis, double angle) const;
    void take(HandleGrip& grip, const TargetDrag::Kind& kind);
    void apply();
    void finishDrag();
    void endDrag();
    void cancelDrag();
    void paintDrag(QPainter& painter) const;

    Viewport& m_viewport;
    Session& m_session;
    HandleGrip* m_across;
    OfAxes<HandleGrip*> m_heads;
    OfAxes<HandleGrip*> m_turns;
    OfAxes<int> m_quadrants{};  ///< of the circles, where the arcs are
    std::optional<Places> m_places;
    std::optional<TargetDrag> m_drag;
    HandleGrip* m_held = nullptr;  ///< while there is a drag
    bool m_isApplying = false;
};

}  // namespace hitscope
