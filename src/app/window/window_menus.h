// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>

class QMainWindow;
class QAction;
class QMenu;
class QMimeData;
class QToolBar;

namespace hitscope {

class Viewport;
struct WindowActions;

/// The window's menus and tool bar: which actions stand where.
class WindowMenus : public QObject {
    Q_OBJECT
public:
    /// Fills the menu bar. All outlive this.
    WindowMenus(QMainWindow& window, Viewport& viewport, const WindowActions& actions);

    /// Once the docks are listed in docks(): behind them the bar is listed.
    void makeToolBar();

    [[nodiscard]] QMenu& docks() { return *m_docks; }
    [[nodiscard]] QMenu& mesh() { return *m_mesh; }
    [[nodiscard]] QMenu& help() { return *m_help; }

Q_SIGNALS:
    void resetLayoutWanted();

private:
    void addDragged(QToolBar& bar, QAction& action, const std::function<QMimeData*()>& make);
    void makeFileMenu();
    void makeViewMenu();
    void makeMeshMenu();
    void makeShootMenu();
    void makeLightsMenu();

    QMainWindow& m_window;
    Viewport& m_viewport;
    const WindowActions& m_actions;
    QMenu* m_docks = nullptr;
    QMenu* m_mesh = nullptr;
    QMenu* m_help = nullptr;
};

}  // namespace hitscope
