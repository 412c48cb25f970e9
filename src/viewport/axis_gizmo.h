// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QWidget>
#include <array>
#include <optional>

#include "viewport/standard_view.h"

class QAction;

namespace hitscope {

class Navigation;

/// The scene's axes in a corner of a view, as the camera sees them. A click on an end looks along that axis,
/// a second click from the other side; dragging turns the camera. Only its disc takes the mouse, and only the
/// left button: the others and the wheel are the view's.
class AxisGizmo : public QWidget {
    Q_OBJECT
public:
    /// `navigation` outlives this.
    AxisGizmo(Navigation& navigation, QWidget* over);

    /// What a click on a view's end does, and what its tooltip is about.
    void setAction(StandardView view, QAction* action);
    [[nodiscard]] QAction* action(StandardView view) const {
        return m_actions[static_cast<std::size_t>(view)];
    }
    /// The view whose end is there; logical pixels of this widget.
    [[nodiscard]] std::optional<StandardView> endAt(const QPointF& at) const;
    /// Where a view's end is now; logical pixels of this widget.
    [[nodiscard]] QPointF endOf(StandardView view) const;

    static constexpr int kSide = 92;  ///< logical pixels

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    void place();
    void hover(const QPointF& at);
    void click(StandardView view);
    /// The views, the farthest end first.
    [[nodiscard]] std::array<StandardView, 6> byDepth() const;
    void paintEnd(QPainter& painter, StandardView view) const;

    Navigation& m_navigation;
    std::array<QAction*, 6> m_actions{};  ///< by StandardView
    std::optional<StandardView> m_hovered;
    bool m_pressed = false;
    bool m_dragged = false;
    QPointF m_pressedAt;
    QPointF m_draggedTo;
};

}  // namespace hitscope
