// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPolygonF>
#include <QWidget>

namespace hitscope {

/// Draws the outline of what a drag will select, over the whole of its parent. Takes no events.
class OutlineOverlay : public QWidget {
    Q_OBJECT
public:
    explicit OutlineOverlay(QWidget* over);
    /// Corners in the parent's logical pixels; empty: hides.
    void show(const QPolygonF& outline);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QPolygonF m_outline;
};

}  // namespace hitscope
