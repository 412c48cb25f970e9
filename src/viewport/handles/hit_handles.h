// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPolygonF>
#include <QWidget>
#include <glm/vec3.hpp>
#include <optional>

#include "session/hit_editing.h"

namespace hitscope {

class HandleGrip;
class Viewport;

/// The selected hit in the picture, to be changed by hand: a ring as large as its max distance with a grip on
/// it, and an arrow along its direction, as deep as its max magnitude. The grip at the arrow's head changes
/// the depth, the one at its tail the direction. A drag is one step to undo; Escape takes it back.
class HitHandles : public QWidget {
    Q_OBJECT
public:
    /// All of them outlive this.
    HitHandles(Viewport& viewport, Session& session, HitEditing& editing);

    /// To where the camera has the hit.
    void follow();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    /// World.
    struct Shape {
        glm::vec3 point;
        glm::vec3 direction;  ///< unit
        float reach;          ///< max distance
        float depth;          ///< max magnitude
    };
    /// Logical pixels of the viewport.
    struct Places {
        QPolygonF ring;
        QPointF point;
        QPointF head;
        QPointF tail;
        QPointF size;  ///< the grip on the ring

        bool operator==(const Places&) const = default;
    };
    [[nodiscard]] std::optional<Shape> shape() const;
    [[nodiscard]] std::optional<Places> placesOf(const Shape& shape) const;
    [[nodiscard]] static QPointF sizeGripOf(const Places& places, const QRectF& inside);
    [[nodiscard]] float distanceInPlane(const QPointF& place) const;
    [[nodiscard]] float alongArrow(const QPointF& place) const;
    [[nodiscard]] glm::vec3 onSphere(const QPointF& place) const;
    void connectGrip(HandleGrip& grip, void (HitHandles::*drag)(const QPointF&));
    void dragSize(const QPointF& to);
    void dragDepth(const QPointF& to);
    void dragDirection(const QPointF& to);
    [[nodiscard]] bool isDragging() const;
    void letGo();

    Viewport& m_viewport;
    Session& m_session;
    HitEditing& m_editing;
    HandleGrip* m_size;
    HandleGrip* m_depth;
    HandleGrip* m_direction;
    std::optional<Places> m_places;
    Shape m_before{};  ///< when the drag began
    QPointF m_from;    ///< and where
    QPointF m_arrow;   ///< unit, along the direction in the picture, then
};

}  // namespace hitscope
