// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractSpinBox>
#include <QObject>
#include <QPointer>

class QKeyEvent;
class QMainWindow;
class QWidget;

namespace hitscope {

/// Lets the window's keys work wherever the focus is, unless text is being edited. In docks and tool bars: a
/// spin box that has the focus takes only what belongs to a number, and all keys once something has been
/// typed into it; where the cursor was put into its text (mouse, Tab, select all), it takes all that can be
/// written, even if it refuses it. Return ends that and gives the focus back to the picture, Escape drops
/// what was typed. Escape and the keys that fly reach the picture from everywhere.
class KeyRouting : public QObject {
    Q_OBJECT
public:
    /// Watches the application's events. Both outlive this.
    KeyRouting(QMainWindow& window, QWidget& picture);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] bool isTop(const QWidget& widget) const;
    [[nodiscard]] bool isInPanel(const QWidget& widget) const;
    /// Returns whether the widget is not to see it.
    bool override(QWidget& widget, QKeyEvent& event) const;
    bool press(QWidget& widget, QKeyEvent& event);
    bool pressInSpinBox(QAbstractSpinBox& box, QKeyEvent& event);
    void handOver(QKeyEvent& event);

    QMainWindow& m_window;
    QWidget& m_picture;
    QPointer<QAbstractSpinBox> m_edited;  ///< whose text the cursor was put into
};

}  // namespace hitscope
