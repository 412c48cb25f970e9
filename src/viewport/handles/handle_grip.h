// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPointF>
#include <QWidget>

namespace hitscope {

/// A small round grip over the picture that is dragged with the left button; the right one gives the drag up.
/// Other buttons and the wheel are the picture's.
class HandleGrip : public QWidget {
    Q_OBJECT
public:
    HandleGrip(QWidget& over, const QString& name, const QString& toolTip);

    /// Centre, logical pixels of the widget it is over.
    void place(const QPointF& centre);
    [[nodiscard]] QPointF centre() const { return m_centre; }
    /// Without: the window's text colour, highlighted under the cursor.
    void setColour(const QColor& colour) { m_colour = colour; }
    void setHollow() { m_isHollow = true; }  ///< a ring, as of what turns
    [[nodiscard]] bool isHeld() const { return m_isHeld; }
    void letGo();  ///< as if the button were released, and nothing is emitted

Q_SIGNALS:
    void taken();
    /// Where its centre would be now, with the cursor.
    void draggedTo(const QPointF& centre, Qt::KeyboardModifiers modifiers);
    void released();
    /// Instead of released(): let go, to be as it was before.
    void cancelled();

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    void release();

    QColor m_colour;
    bool m_isHollow = false;
    QPointF m_centre;
    QPointF m_offset;  ///< from the cursor to the centre, while it is held
    bool m_isHeld = false;
    bool m_isOver = false;
};

}  // namespace hitscope
