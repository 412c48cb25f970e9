// SPDX-License-Identifier: GPL-3.0-or-later
// The window's menus and tool bar: who fills which.
#include <QComboBox>
#include <QLabel>
#include <QMenuBar>
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
#include "app/actions/picture_actions.h"
#include "app/actions/repeat_actions.h"
#include "app/actions/shot_actions.h"
#include "app/actions/theme_actions.h"
#include "app/actions/time_actions.h"
#include "app/dialogs/dialogs.h"
#include "app/dialogs/go_to_vertex.h"
#include "app/dialogs/projectile_dialog.h"
#include "app/dialogs/texture_locator.h"
#include "app/full_view.h"
#include "app/main_window.h"
#include "app/overlays/keys_overlay.h"
#include "app/pipeline_chooser.h"
#include "models/verdict_text.h"
#include "panels/icons/themed_icon.h"
#include "viewport/viewport.h"

namespace hitscope {

void MainWindow::makeMenus() {
    QMenu& file = *menuBar()->addMenu(tr("&File"));
    m_fileActions->fill(file);
    fillSharing(file);
    m_exports->fill(file);
    m_hitActions->fill(file);
    m_pictures->fill(file);
    file.addSeparator();
    hitscope::addAction(file, tr("&Quit"), tr("Ctrl+Q"), this, [this] { close(); });
    QMenu& edit = *menuBar()->addMenu(tr("&Edit"));
    m_edit->fill(edit);
    m_exchange->fill(edit);
    m_cameraActions->fillEdit(edit);
    makeViewMenu();
    m_meshMenu = menuBar()->addMenu(tr("&Mesh"));
    m_fileActions->fillMesh(*m_meshMenu);
    m_textureLocator->fill(*m_meshMenu);
    m_meshMenu->addSeparator();
    auto* meshActions = new MeshActions(m_session, m_shots->aimPreview(), *this);
    meshActions->fill(*m_meshMenu);
    connect(meshActions, &MeshActions::said, this, &MainWindow::say);
    connect(meshActions, &MeshActions::failed, this, &MainWindow::fail);
    m_meshMenu->addSeparator();
    m_pipelines->fill(*m_meshMenu->addMenu(tr("&Pipeline")));
    makeShootMenu();
    QMenu& inspect = *menuBar()->addMenu(tr("&Inspect"));
    m_inspect->fill(inspect);
    inspect.addSeparator();
    m_goToVertex->fill(inspect);
    m_lights->fill(*menuBar()->addMenu(tr("&Lights")));
    const auto followEnvironment = [this] { m_lights->setEnvironment(m_viewport->options().environment); };
    connect(m_viewport, &Viewport::optionsChanged, m_lights, followEnvironment);
    followEnvironment();
    makeHelpMenu();
}

void MainWindow::makeViewMenu() {
    QMenu& menu = *menuBar()->addMenu(tr("&View"));
    m_display->fill(menu, [this](QMenu& middle) {
        m_change->fill(*middle.addMenu(tr("Chan&ge")));
        m_cut->fill(*middle.addMenu(tr("Cutting &Plane")));
    });
    menu.addSeparator();
    m_frame = hitscope::addAction(
        menu, tr("&Frame Selection"), Qt::Key_F, this, [this] { m_viewport->frameSelection(); },
        QStringLiteral("frame"));
    m_cameraActions->fill(menu);
    menu.addSeparator();
    m_docksMenu = menu.addMenu(tr("&Docks"));
    m_themes->fill(menu);
    hitscope::addAction(menu, tr("&Reset Layout"), {}, this, [this] { resetLayout(); });
    m_fullView->fill(menu);
    addToggle(menu, tr("F&ull Screen"), Qt::Key_F11, false, this,
              [this](bool on) { setWindowState(windowState().setFlag(Qt::WindowFullScreen, on)); });
    menu.addSeparator();
    m_continuous = addToggle(menu, tr("Draw C&ontinuously"), {}, false, this,
                             [this](bool on) { m_viewport->setDrawsContinuously(on); });
    m_continuous->setIcon(themedIcon(QStringLiteral("continuous")));
    m_continuous->setIconVisibleInMenu(false);  // it would hide the check mark
    m_continuous->setToolTip(tr("Draw frames even when nothing changes, to measure the frame rate"));
}

void MainWindow::makeShootMenu() {
    QMenu& menu = *menuBar()->addMenu(tr("&Shoot"));
    addHeldKey(menu, tr("&Shoot at the Crosshair"), tr("Space"), this,
               [this] { m_viewport->shootAtCrosshair(); });
    m_shots->fill(menu);
    menu.addSeparator();
    m_repeat->fill(menu);
    menu.addSeparator();
    QAction* bounces = addToggle(menu, tr("&Bounces Count as Hits"), {},
                                 m_session.settings().projectile().bouncesCount, this, [this](bool on) {
                                     ProjectileSettings settings = m_session.settings().projectile();
                                     settings.bouncesCount = on;
                                     m_session.settings().setProjectile(settings);
                                 });
    hitscope::addAction(menu, tr("&Projectile…"), {}, this, [this] { showProjectileDialog(); });
    menu.addSeparator();
    m_time->fill(menu);
    connect(&m_session.settings(), &SessionSettings::projectileChanged, this,
            [this, bounces] { bounces->setChecked(m_session.settings().projectile().bouncesCount); });
}

void MainWindow::showProjectileDialog() {
    auto* dialog = findChild<ProjectileDialog*>();
    if (dialog == nullptr) {
        dialog = new ProjectileDialog(m_session, this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
    }
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
}

void MainWindow::showKeys() {
    auto* overlay = findChild<KeysOverlay*>();
    if (overlay == nullptr) {
        overlay = new KeysOverlay(*this);
    }
    const Navigation& navigation = m_viewport->navigation();
    overlay->toggle({mouseKeys(navigation.preset(), navigation.orbitMode()), heldKeys()});
}

void MainWindow::makeHelpMenu() {
    QMenu& menu = *menuBar()->addMenu(tr("&Help"));
    hitscope::addAction(menu, tr("&Keys and Mouse"), Qt::Key_F1, this, [this] { showKeys(); });
    m_helpMenu = &menu;
    menu.addSeparator();
    m_help->fill(menu);
    menu.addSeparator();
    hitscope::addAction(menu, tr("&About Hitscope"), {}, this, [this] {
        showAbout(this, m_viewport->rendererName(), m_viewport->rendererVersion(),
                  verdictText(m_session.readBack().verdict(), m_session.settings().pipeline()));
    });
}

void MainWindow::makeToolBar() {
    QToolBar& bar = *addToolBar(tr("Tools"));
    bar.setObjectName(QStringLiteral("tools"));
    bar.setIconSize({20, 20});
    bar.addAction(m_fileActions->open());
    bar.addAction(m_exports->exportMesh());
    bar.addSeparator();
    bar.addAction(m_edit->undo());
    bar.addAction(m_edit->redo());
    bar.addSeparator();
    m_inspect->fill(bar);
    m_shots->fill(bar);
    connect(m_shots, &ShotActions::chosenInBox, m_viewport, [this] { m_viewport->setFocus(); });
    bar.addSeparator();
    auto* wireframe = new QToolButton(&bar);
    wireframe->setIcon(themedIcon(QStringLiteral("wireframe")));
    wireframe->setToolTip(tr("Wireframe: off, over, only (L)"));
    wireframe->setPopupMode(QToolButton::MenuButtonPopup);
    wireframe->setMenu(m_display->wireframeMenu());
    connect(wireframe, &QToolButton::clicked, m_display, &DisplayActions::cycleWireframe);
    bar.addWidget(wireframe);
    bar.addAction(m_cut->toggle());
    bar.addAction(m_frame);
    bar.addSeparator();
    m_time->fill(bar);
    connect(m_time, &TimeActions::numberTyped, m_viewport, [this] { m_viewport->setFocus(); });
    bar.addSeparator();
    auto* label = new QLabel(tr("Pipeline"), &bar);
    label->setContentsMargins(6, 0, 6, 0);
    bar.addWidget(label);
    bar.addWidget(m_pipelines->makeBox(&bar));
    connect(m_pipelines, &PipelineChooser::chosenInBox, m_viewport,
            [this] { m_viewport->setFocus(); });  // where the keys are expected next
    m_docksMenu->addSeparator();
    m_docksMenu->addAction(bar.toggleViewAction());
}

}  // namespace hitscope
