// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QList>
#include <QObject>

class QAction;
class QMainWindow;
class QMenu;

namespace hitscope {

/// The central widget alone on the whole screen, and back: docks, bars and the window are then as they were.
/// Its menu has the whole window on the whole screen too.
class FullView : public QObject {
    Q_OBJECT
public:
    explicit FullView(QMainWindow& window);

    void fill(QMenu& menu);
    [[nodiscard]] bool isOn() const { return m_on; }
    void set(bool on);

protected:
    /// The window manager, a restored geometry and our own keys change its state: the action shows it.
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void followState();
    void borrowKeys();
    void giveKeysBack();

    QMainWindow& m_window;
    QAction* m_toggle = nullptr;
    QAction* m_fullScreen = nullptr;
    QAction* m_leave = nullptr;  ///< Escape, while it is on
    bool m_on = false;
    QList<QAction*> m_borrowed;
    QByteArray m_layout;
    Qt::WindowStates m_state;
};

}  // namespace hitscope
