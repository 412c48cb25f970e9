// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QWidget>
#include <glm/vec3.hpp>
#include <optional>

#include "core/bounds.h"
#include "view/cutting_plane.h"

namespace hitscope {

class Viewport;

/// A grip in the middle of the cutting plane, over the picture: dragged, it moves the plane along its normal;
/// looking along that, up is away. Ctrl keeps to round offsets; Escape or the right button takes the drag
/// back. There while the viewport's plane is on.
class CutHandle : public QWidget {
    Q_OBJECT
public:
    explicit CutHandle(Viewport& viewport);

    /// What the plane moves through: of the targets, world.
    void setBounds(const Bounds& bounds);
    /// To where the viewport's camera and plane have it.
    void follow();
    [[nodiscard]] bool isDragging() const { return m_drag.has_value(); }

Q_SIGNALS:
    void dragged(float offset);  ///< metres along the normal, within the bounds
    void released();             ///< the drag has ended
    void hovered(bool over);     ///< or dragging

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    struct Drag {
        float offset;       ///< when it began
        QPointF from;       ///< logical pixels of the viewport
        glm::vec3 middle;   ///< of the plane then
        bool isAlongSight;  ///< the normal is no direction in the picture
    };
    [[nodiscard]] glm::vec3 middle() const;
    [[nodiscard]] float moved(const Drag& drag, const QPointF& to) const;
    void endDrag();
    void cancelDrag();

    Viewport& m_viewport;
    Bounds m_bounds;
    QPointF m_arrow;  ///< unit, the normal in the picture; null: along the sight
    bool m_over = false;
    std::optional<Drag> m_drag;
};

}  // namespace hitscope
