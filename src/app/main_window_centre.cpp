// SPDX-License-Identifier: GPL-3.0-or-later
// The window's middle: the picture, with notices above it and the card of first steps below.
#include <QMenu>
#include <QSettings>
#include <QVBoxLayout>

#include "app/actions/inspect_actions.h"
#include "app/discard_guard.h"
#include "app/main_window.h"
#include "app/notice_bar.h"
#include "app/start_card.h"
#include "viewport/viewport.h"

namespace hitscope {

void MainWindow::makeCentre() {
    auto* centre = new QWidget(this);
    centre->setFocusProxy(m_viewport);
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins({});
    column->setSpacing(0);
    column->addWidget(m_notice);
    column->addWidget(m_viewport, 1);
    setCentralWidget(centre);
}

void MainWindow::makeStartCard() {
    m_startCard = new StartCard(
        {.inspect = m_inspect->inspect(), .exportMesh = m_export, .open = m_open, .samples = m_scenesMenu},
        this);
    centralWidget()->layout()->addWidget(m_startCard);
    m_helpMenu->insertAction(m_helpMenu->actions().value(1), m_startCard->toggle());
    connect(m_viewport, &Viewport::shot, m_startCard, &StartCard::dismiss);
}

void MainWindow::showFirstSteps() {
    m_guard->letGo();  // the first scene's dent is not the person's
    m_startCard->restore(QSettings());
}

}  // namespace hitscope
