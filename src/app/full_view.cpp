// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/full_view.h"

#include <QAction>
#include <QDockWidget>
#include <QEvent>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QStatusBar>
#include <QToolBar>
#include <utility>

#include "app/actions/menu_building.h"
#include "panels/help/help_text.h"

namespace hitscope {

namespace {

void collectActions(const QWidget& menu, QList<QAction*>& actions) {
    for (QAction* action : menu.actions()) {
        if (const QMenu* inner = action->menu()) {
            collectActions(*inner, actions);
        } else if (!action->shortcuts().isEmpty()) {
            actions.append(action);
        }
    }
}

}  // namespace

FullView::FullView(QMainWindow& window)
    : QObject(&window), m_window(window), m_toggle(new QAction(this)), m_leave(new QAction(&window)) {
    m_toggle->setText(tr("&Viewport Only"));
    m_toggle->setShortcuts(
        {QKeySequence(Qt::AltModifier | Qt::Key_Return), QKeySequence(Qt::AltModifier | Qt::Key_Enter)});
    m_toggle->setCheckable(true);
    m_leave->setShortcut(Qt::Key_Escape);
    enableIf(*m_leave, false, tr("All parts of the window are shown."));
    window.addAction(m_leave);
    connect(m_toggle, &QAction::triggered, this, &FullView::set);
    connect(m_leave, &QAction::triggered, this, [this] { set(false); });
}

void FullView::fill(QMenu& menu) {
    menu.addAction(m_toggle);
    m_fullScreen = addToggle(menu, tr("F&ull Screen"), Qt::Key_F11, false, this, [this](bool on) {
        m_window.setWindowState(m_window.windowState().setFlag(Qt::WindowFullScreen, on));
    });
    m_window.installEventFilter(this);
    followState();
}

bool FullView::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &m_window && event->type() == QEvent::WindowStateChange) {
        followState();
    }
    return QObject::eventFilter(watched, event);
}

void FullView::followState() {
    m_fullScreen->setChecked(m_window.windowState().testFlag(Qt::WindowFullScreen));
}

/// The keys of a menu bar that is hidden do not count; those of the window do.
void FullView::borrowKeys() {
    collectActions(*m_window.menuBar(), m_borrowed);
    m_window.addActions(m_borrowed);
}

void FullView::giveKeysBack() {
    for (QAction* action : std::exchange(m_borrowed, {})) {
        m_window.removeAction(action);
    }
}

void FullView::set(bool on) {
    if (on == m_on) {
        return;
    }
    m_on = on;
    m_toggle->setChecked(on);
    enableIf(*m_leave, on, tr("All parts of the window are shown."));
    m_window.menuBar()->setVisible(!on);
    m_window.statusBar()->setVisible(!on);
    if (on) {
        borrowKeys();
        m_layout = m_window.saveState();
        m_state = m_window.windowState();
        for (QDockWidget* dock : m_window.findChildren<QDockWidget*>()) {
            dock->hide();
        }
        for (QToolBar* bar : m_window.findChildren<QToolBar*>()) {
            bar->hide();
        }
        m_window.setWindowState(m_state | Qt::WindowFullScreen);
        m_window.centralWidget()->setFocus();
    } else {
        giveKeysBack();
        m_window.setWindowState(m_state);
        m_window.restoreState(m_layout);
    }
}

}  // namespace hitscope
