// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/window_menus.h"

#include <QComboBox>
#include <QLabel>
#include <QMainWindow>
#include <QMenuBar>
#include <QMimeData>
#include <QToolBar>
#include <QToolButton>

#include "app/actions/camera_actions.h"
#include "app/actions/change_actions.h"
#include "app/actions/cut_actions.h"
#include "app/actions/display_actions.h"
#include "app/actions/edit_actions.h"
#include "app/actions/exchange_actions.h"
#include "app/actions/export_actions.h"
#include "app/actions/file_actions.h"
#include "app/actions/help_actions.h"
#include "app/actions/hit_actions.h"
#include "app/actions/inspect_actions.h"
#include "app/actions/light_actions.h"
#include "app/actions/menu_building.h"
#include "app/actions/mesh_actions.h"
#include "app/actions/outgoing_files.h"
#include "app/actions/picture_actions.h"
#include "app/actions/projectile_actions.h"
#include "app/actions/repeat_actions.h"
#include "app/actions/shot_actions.h"
#include "app/actions/theme_actions.h"
#include "app/actions/time_actions.h"
#include "app/dialogs/go_to_vertex.h"
#include "app/dialogs/texture_locator.h"
#include "app/full_view.h"
#include "app/pipeline_chooser.h"
#include "app/session_collector.h"
#include "app/window/window_actions.h"
#include "panels/fields/drag_out.h"
#include "panels/icons/themed_icon.h"
#include "viewport/viewport.h"

namespace hitscope {

WindowMenus::WindowMenus(QMainWindow& window, Viewport& viewport, const WindowActions& actions)
    : QObject(&window), m_window(window), m_viewport(viewport), m_actions(actions) {
    makeFileMenu();
    QMenu& edit = *m_window.menuBar()->addMenu(tr("&Edit"));
    m_actions.edit->fill(edit);
    m_actions.exchange->fill(edit);
    m_actions.cameras->fillEdit(edit);
    makeViewMenu();
    makeMeshMenu();
    makeShootMenu();
    QMenu& inspect = *m_window.menuBar()->addMenu(tr("&Inspect"));
    m_actions.inspect->fill(inspect);
    inspect.addSeparator();
    m_actions.goToVertex->fill(inspect);
    makeLightsMenu();
    m_help = m_window.menuBar()->addMenu(tr("&Help"));
    m_actions.help->fill(*m_help);
}

void WindowMenus::makeFileMenu() {
    QMenu& menu = *m_window.menuBar()->addMenu(tr("&File"));
    m_actions.file->fill(menu);
    m_actions.collector->fill(menu);
    m_actions.exports->fill(menu);
    m_actions.hits->fill(menu);
    m_actions.pictures->fill(menu);
    menu.addSeparator();
    addAction(menu, tr("&Quit"), tr("Ctrl+Q"), this, [this] { m_window.close(); });
}

void WindowMenus::makeViewMenu() {
    QMenu& menu = *m_window.menuBar()->addMenu(tr("&View"));
    m_actions.display->fill(menu, [this](QMenu& middle) {
        m_actions.change->fill(*middle.addMenu(tr("Chan&ge")));
        m_actions.cut->fill(*middle.addMenu(tr("Cutting &Plane")));
    });
    menu.addSeparator();
    m_actions.cameras->fill(menu);
    menu.addSeparator();
    m_docks = menu.addMenu(tr("&Docks"));
    m_actions.themes->fill(menu);
    addAction(menu, tr("&Reset Layout"), {}, this, [this] { Q_EMIT resetLayoutWanted(); });
    m_actions.fullView->fill(menu);
    menu.addSeparator();
    m_actions.display->fillEnd(menu);
}

void WindowMenus::makeMeshMenu() {
    m_mesh = m_window.menuBar()->addMenu(tr("&Mesh"));
    m_actions.file->fillMesh(*m_mesh);
    m_actions.textureLocator->fill(*m_mesh);
    m_mesh->addSeparator();
    m_actions.mesh->fill(*m_mesh);
    m_mesh->addSeparator();
    m_actions.pipelines->fill(*m_mesh->addMenu(tr("&Pipeline")));
}

void WindowMenus::makeShootMenu() {
    QMenu& menu = *m_window.menuBar()->addMenu(tr("&Shoot"));
    m_actions.shots->fill(menu);
    menu.addSeparator();
    m_actions.repeat->fill(menu);
    menu.addSeparator();
    m_actions.projectile->fill(menu);
    menu.addSeparator();
    m_actions.time->fill(menu);
}

void WindowMenus::makeLightsMenu() {
    m_actions.lights->fill(*m_window.menuBar()->addMenu(tr("&Lights")));
    const auto follow = [this] { m_actions.lights->setEnvironment(m_viewport.options().environment); };
    connect(&m_viewport, &Viewport::optionsChanged, m_actions.lights, follow);
    follow();
}

/// A button that can be dragged out as a file, too.
void WindowMenus::addDragged(QToolBar& bar, QAction& action, const std::function<QMimeData*()>& make) {
    bar.addAction(&action);
    if (auto* button = qobject_cast<QToolButton*>(bar.widgetForAction(&action))) {
        new DragOut(*button, make);
    }
    action.setToolTip(
        tr("%1; drag it out of the window for a file").arg(action.toolTip().remove(QStringLiteral("…"))));
}

void WindowMenus::makeToolBar() {
    QToolBar& bar = *m_window.addToolBar(tr("Tools"));
    bar.setObjectName(QStringLiteral("tools"));
    bar.setIconSize({20, 20});
    bar.addAction(m_actions.file->open());
    OutgoingFiles& out = m_actions.exchange->outgoing();
    addDragged(bar, *m_actions.file->saveSession(), [&out] { return out.session(); });
    addDragged(bar, *m_actions.exports->exportMesh(), [&out] { return out.mesh(); });
    addDragged(bar, *m_actions.pictures->saveAction(), [&out] { return out.picture(); });
    bar.addSeparator();
    bar.addAction(m_actions.edit->undo());
    bar.addAction(m_actions.edit->redo());
    bar.addSeparator();
    m_actions.inspect->fill(bar);
    m_actions.shots->fill(bar);
    bar.addSeparator();
    auto* wireframe = new QToolButton(&bar);
    wireframe->setIcon(themedIcon(QStringLiteral("wireframe")));
    wireframe->setToolTip(tr("Wireframe: off, over, only (L)"));
    wireframe->setPopupMode(QToolButton::MenuButtonPopup);
    wireframe->setMenu(m_actions.display->wireframeMenu());
    connect(wireframe, &QToolButton::clicked, m_actions.display, &DisplayActions::cycleWireframe);
    bar.addWidget(wireframe);
    bar.addAction(m_actions.cut->toggle());
    bar.addAction(m_actions.cameras->frame());
    bar.addSeparator();
    m_actions.time->fill(bar);
    bar.addSeparator();
    auto* label = new QLabel(tr("Pipeline"), &bar);
    label->setContentsMargins(6, 0, 6, 0);
    bar.addWidget(label);
    bar.addWidget(m_actions.pipelines->makeBox(&bar));
    // What was chosen or typed is done with: the picture gets the keys back.
    const auto leaveBar = [this] { m_viewport.setFocus(); };
    connect(m_actions.shots, &ShotActions::chosenInBox, &m_viewport, leaveBar);
    connect(m_actions.time, &TimeActions::numberTyped, &m_viewport, leaveBar);
    connect(m_actions.pipelines, &PipelineChooser::chosenInBox, &m_viewport, leaveBar);
    m_docks->addSeparator();
    m_docks->addAction(bar.toggleViewAction());
}

}  // namespace hitscope
