// SPDX-License-Identifier: GPL-3.0-or-later
// The window's menus and tool bar.
#include <QActionGroup>
#include <QComboBox>
#include <QLabel>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>
#include <utility>

#include "app/actions/camera_actions.h"
#include "app/actions/change_actions.h"
#include "app/actions/cut_actions.h"
#include "app/actions/help_actions.h"
#include "app/actions/hit_actions.h"
#include "app/actions/inspect_actions.h"
#include "app/actions/picture_actions.h"
#include "app/actions/shading_actions.h"
#include "app/actions/shot_actions.h"
#include "app/actions/time_actions.h"
#include "app/dialogs/dialogs.h"
#include "app/dialogs/go_to_vertex.h"
#include "app/dialogs/projectile_dialog.h"
#include "app/dialogs/texture_chooser.h"
#include "app/dialogs/texture_locator.h"
#include "app/discard_guard.h"
#include "app/full_view.h"
#include "app/keys_overlay.h"
#include "app/main_window.h"
#include "app/pipeline_chooser.h"
#include "panels/icons/themed_icon.h"
#include "viewport/viewport.h"

namespace hitscope {

QAction* MainWindow::addAction(QMenu& menu, const QString& text, const QKeySequence& keys,
                               std::function<void()> act, const QString& icon) {
    QAction* action = menu.addAction(text);
    action->setShortcut(keys);
    if (!icon.isEmpty()) {
        action->setIcon(themedIcon(icon));
    }
    connect(action, &QAction::triggered, this, [run = std::move(act)] { run(); });
    return action;
}

QAction* MainWindow::addToggle(QMenu& menu, const QString& text, const QKeySequence& keys, bool on,
                               std::function<void(bool)> act) {
    QAction* action = menu.addAction(text);
    action->setShortcut(keys);
    action->setCheckable(true);
    action->setChecked(on);
    connect(action, &QAction::triggered, this, [run = std::move(act)](bool checked) { run(checked); });
    return action;
}

QAction* MainWindow::addChoice(QMenu& menu, QActionGroup& group, const QString& text, bool on,
                               std::function<void()> act) {
    QAction* action = addToggle(menu, text, {}, on, [run = std::move(act)](bool) { run(); });
    group.addAction(action);
    return action;
}

QAction* MainWindow::addHeldKey(QMenu& menu, const QString& text, const QString& key,
                                std::function<void()> act) {
    return addAction(menu, text + u'\t' + key, {}, std::move(act));
}

void MainWindow::makeMenus() {
    makeFileMenu();
    makeEditMenu();
    makeViewMenu();
    makeMeshMenu();
    makeShootMenu();
    QMenu& inspect = *menuBar()->addMenu(tr("&Inspect"));
    m_inspect->fill(inspect);
    inspect.addSeparator();
    m_goToVertex->fill(inspect);
    makeLightsMenu();
    makeHelpMenu();
}

void MainWindow::makeFileMenu() {
    QMenu& menu = *menuBar()->addMenu(tr("&File"));
    QAction* fresh = addAction(menu, tr("&New Scene"), QKeySequence::New, [this] {
        sayNotYet(
            tr("There is no empty scene yet. File > Scenes has ready ones, and File > Open takes a mesh."));
    });
    fresh->setStatusTip(tr("Will start an empty scene; there is none yet"));
    m_open = addAction(
        menu, tr("&Open…"), QKeySequence::Open, [this] { chooseFile(); }, QStringLiteral("open"));
    m_recentMenu = menu.addMenu(tr("Open &Recent"));
    m_recentMenu->setToolTipsVisible(true);
    connect(m_recentMenu, &QMenu::aboutToShow, this, &MainWindow::showRecentFiles);
    addAction(menu, tr("&Add to Scene…"), tr("Ctrl+Shift+O"), [this] { chooseAddition(); });
    menu.addSeparator();
    QMenu& scenes = *menu.addMenu(tr("&Scenes"));
    m_scenesMenu = &scenes;
    QMenu& rows = *scenes.addMenu(tr("Paper's &Tables"));
    for (std::size_t row = 0; row < paperRows().size(); ++row) {
        addAction(rows, tr("Row %1: %2").arg(row + 1).arg(paperRows()[row].label()), {}, [this, row] {
            m_guard->ask([this, row] { m_session.loadPaperRow(static_cast<int>(row)); });
        });
    }
    addAction(scenes, tr("&Utah Teapot"), {}, [this] { m_guard->ask([this] { m_session.loadTeapot(); }); });
    for (const SampleScene sample : allSampleScenes()) {
        addAction(scenes, sampleSceneName(sample), {},
                  [this, sample] { m_guard->ask([this, sample] { loadSample(sample); }); });
    }
    menu.addSeparator();
    QAction* save = addAction(menu, tr("&Save Session"), QKeySequence::Save, [this] {
        sayNotYet(
            tr("Sessions cannot be saved yet. Export the deformed mesh (Ctrl+E), or the hits (File > Export "
               "Hits), to keep your work."));
    });
    save->setStatusTip(tr("Will save meshes, hits and settings in one file; sessions cannot be saved yet"));
    m_export = addAction(
        menu, tr("&Export Deformed Mesh…"), tr("Ctrl+E"), [this] { chooseExport(); },
        QStringLiteral("export"));
    m_hitActions->fill(menu);
    m_pictures->fill(menu);
    menu.addSeparator();
    addAction(menu, tr("&Quit"), tr("Ctrl+Q"), [this] { close(); });
}

void MainWindow::makeEditMenu() {
    QMenu& menu = *menuBar()->addMenu(tr("&Edit"));
    m_undo = addAction(
        menu, tr("&Undo"), QKeySequence::Undo, [this] { m_session.undo(); }, QStringLiteral("undo"));
    m_redo = addAction(
        menu, tr("&Redo"), tr("Ctrl+Shift+Z"), [this] { m_session.redo(); }, QStringLiteral("redo"));
    menu.addSeparator();
    m_enableAll = addAction(menu, tr("&Enable All Hits"), {}, [this] { m_session.enableAllHits(); });
    m_clear = addAction(
        menu, tr("&Clear Hits"), tr("Ctrl+Shift+Del"), [this] { m_session.clearHits(); },
        QStringLiteral("remove"));
    menu.addSeparator();
    m_cameraActions->fillEdit(menu);
}

QMenu* MainWindow::makeWireframeMenu() {
    auto* menu = new QMenu(tr("&Wireframe"), this);
    auto* group = new QActionGroup(this);
    const QString names[] = {tr("&Off"), tr("O&ver the Surface"), tr("O&nly")};
    for (int mode = 0; mode < 3; ++mode) {
        m_wireframes[mode] = addChoice(*menu, *group, names[mode], false, [this, mode] {
            changeDisplay(
                [mode](DisplayOptions& display) { display.wireframe = static_cast<WireframeMode>(mode); });
        });
    }
    menu->addSeparator();
    addAction(*menu, tr("Next &Mode"), Qt::Key_L, [this] { cycleWireframe(); });
    return menu;
}

void MainWindow::makeDisplayActions(QMenu& menu) {
    m_wireframeMenu = makeWireframeMenu();
    menu.addMenu(m_wireframeMenu);
    m_shading = new ShadingActions(this);
    m_shading->fill(*menu.addMenu(tr("S&hading")));
    connect(m_shading, &ShadingActions::switched, this, [this](DisplayOption option, bool on) {
        changeDisplay([option, on](DisplayOptions& display) { display.*option = on; });
    });
    QMenu& normals = *menu.addMenu(tr("&Normals"));
    auto* group = new QActionGroup(this);
    const QString names[] = {tr("&True (of the Dented Surface)"), tr("&Paper (Equation 2)")};
    for (int mode = 0; mode < 2; ++mode) {
        m_normals[mode] = addChoice(normals, *group, names[mode], false, [this, mode] {
            changeDisplay(
                [mode](DisplayOptions& display) { display.normals = static_cast<NormalMode>(mode); });
        });
    }
    normals.addSeparator();
    addAction(normals, tr("&Switch"), Qt::Key_N, [this] {
        changeDisplay([](DisplayOptions& display) {
            display.normals = display.normals == NormalMode::True ? NormalMode::Paper : NormalMode::True;
        });
    });
    QMenu& textures = *menu.addMenu(tr("Te&xture"));
    m_textureChooser = new TextureChooser(m_session, this);
    m_textureChooser->fill(textures);
    textures.addSeparator();
    m_textures = addToggle(textures, tr("&Show Textures"), Qt::Key_T, true, [this](bool on) {
        changeDisplay([on](DisplayOptions& display) { display.textures = on; });
    });
    m_change->fill(*menu.addMenu(tr("Chan&ge")));
    m_cut->fill(*menu.addMenu(tr("Cutting &Plane")));
    m_floor = addToggle(menu, tr("F&loor"), {}, true, [this](bool on) {
        changeDisplay([on](DisplayOptions& display) { display.floor = on; });
    });
    m_crosshair = addToggle(menu, tr("&Crosshair"), Qt::Key_C, false, [this](bool on) {
        changeDisplay([on](DisplayOptions& display) { display.crosshair = on; });
    });
}

void MainWindow::makeViewMenu() {
    QMenu& menu = *menuBar()->addMenu(tr("&View"));
    makeDisplayActions(menu);
    menu.addSeparator();
    m_frame = addAction(
        menu, tr("&Frame Selection"), Qt::Key_F, [this] { m_viewport->frameSelection(); },
        QStringLiteral("frame"));
    m_cameraActions->fill(menu);
    menu.addSeparator();
    m_docksMenu = menu.addMenu(tr("&Docks"));
    makeThemeMenus(menu);
    addAction(menu, tr("&Reset Layout"), {}, [this] { resetLayout(); });
    m_fullView->fill(menu);
    addToggle(menu, tr("F&ull Screen"), Qt::Key_F11, false,
              [this](bool on) { setWindowState(windowState().setFlag(Qt::WindowFullScreen, on)); });
    menu.addSeparator();
    m_continuous = addToggle(menu, tr("Draw C&ontinuously"), {}, false,
                             [this](bool on) { m_viewport->setDrawsContinuously(on); });
    m_continuous->setIcon(themedIcon(QStringLiteral("continuous")));
    m_continuous->setIconVisibleInMenu(false);  // it would hide the check mark
    m_continuous->setToolTip(tr("Draw frames even when nothing changes, to measure the frame rate"));
}

void MainWindow::makeThemeMenus(QMenu& menu) {
    QMenu& window = *menu.addMenu(tr("&Theme"));
    auto* themes = new QActionGroup(this);
    const std::pair<QString, ThemeChoice> choices[] = {{tr("Follow &Desktop"), ThemeChoice::System},
                                                       {tr("&Light"), ThemeChoice::Light},
                                                       {tr("&Dark"), ThemeChoice::Dark}};
    for (const auto& [name, choice] : choices) {
        addChoice(window, *themes, name, m_settings.theme == choice,
                  [this, chosen = choice] { chooseTheme(chosen); });
    }
    QMenu& viewport = *menu.addMenu(tr("Viewport &Background"));
    auto* backgrounds = new QActionGroup(this);
    const std::pair<QString, std::optional<Theme>> shades[] = {
        {tr("Follow &Window"), std::nullopt}, {tr("&Light"), Theme::Light}, {tr("&Dark"), Theme::Dark}};
    for (const auto& [name, shade] : shades) {
        addChoice(viewport, *backgrounds, name, m_settings.viewportTheme == shade, [this, chosen = shade] {
            m_settings.viewportTheme = chosen;
            followViewportTheme();
        });
    }
}

void MainWindow::makeMeshMenu() {
    m_meshMenu = menuBar()->addMenu(tr("&Mesh"));
    QMenu& menu = *m_meshMenu;
    m_placeMesh = addAction(menu, tr("&Centre and Scale…"), {}, [this] { choosePlacement(); });
    m_fileCoordinates = addAction(menu, tr("File's Own C&oordinates"), {},
                                  [this] { m_guard->ask([this] { placeMesh(0.0); }); });
    m_textureLocator = new TextureLocator(m_session, this);
    m_textureLocator->fill(menu);
    menu.addSeparator();
    m_pipelines->fill(*menu.addMenu(tr("&Pipeline")));
}

void MainWindow::makeShootMenu() {
    QMenu& menu = *menuBar()->addMenu(tr("&Shoot"));
    addHeldKey(menu, tr("&Shoot at the Crosshair"), tr("Space"), [this] { m_viewport->shootAtCrosshair(); });
    m_shots->fill(menu);
    menu.addSeparator();
    m_bounces = addToggle(menu, tr("&Bounces Count as Hits"), {}, m_session.projectileSettings().bouncesCount,
                          [this](bool on) {
                              ProjectileSettings settings = m_session.projectileSettings();
                              settings.bouncesCount = on;
                              m_session.setProjectileSettings(settings);
                          });
    addAction(menu, tr("&Projectile…"), {}, [this] { showProjectileDialog(); });
    menu.addSeparator();
    m_time->fill(menu);
    connect(&m_session, &Session::projectileSettingsChanged, this,
            [this] { m_bounces->setChecked(m_session.projectileSettings().bouncesCount); });
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

void MainWindow::makeLightsMenu() {
    QMenu& menu = *menuBar()->addMenu(tr("&Lights"));
    m_lights[0] = addToggle(menu, tr("&Directional"), Qt::Key_G, true, [this](bool on) {
        toggleLight([on](Lights& lights) { lights.directional.on = on; });
    });
    m_lights[1] = addToggle(menu, tr("&Point Lights"), Qt::Key_H, true, [this](bool on) {
        toggleLight([on](Lights& lights) {
            for (PointLight& light : lights.points) {
                light.on = on;
            }
        });
    });
    m_lights[2] = addToggle(menu, tr("&Spotlight"), Qt::Key_J, true,
                            [this](bool on) { toggleLight([on](Lights& lights) { lights.spot.on = on; }); });
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
    addAction(menu, tr("&Keys and Mouse"), Qt::Key_F1, [this] { showKeys(); });
    m_helpMenu = &menu;
    menu.addSeparator();
    m_help->fill(menu);
    menu.addSeparator();
    addAction(menu, tr("&About Hitscope"), {}, [this] {
        showAbout(this, m_viewport->rendererName(), m_viewport->rendererVersion(),
                  QString::fromStdString(describe(m_session.readBack().verdict(), m_session.pipeline())));
    });
}

void MainWindow::makeToolBar() {
    QToolBar& bar = *addToolBar(tr("Tools"));
    bar.setObjectName(QStringLiteral("tools"));
    bar.setIconSize({20, 20});
    bar.addAction(m_open);
    bar.addAction(m_export);
    bar.addSeparator();
    bar.addAction(m_undo);
    bar.addAction(m_redo);
    bar.addSeparator();
    m_inspect->fill(bar);
    m_shots->fill(bar);
    connect(m_shots, &ShotActions::chosenInBox, m_viewport, [this] { m_viewport->setFocus(); });
    bar.addSeparator();
    auto* wireframe = new QToolButton(&bar);
    wireframe->setIcon(themedIcon(QStringLiteral("wireframe")));
    wireframe->setToolTip(tr("Wireframe: off, over, only (L)"));
    wireframe->setPopupMode(QToolButton::MenuButtonPopup);
    wireframe->setMenu(m_wireframeMenu);
    connect(wireframe, &QToolButton::clicked, this, &MainWindow::cycleWireframe);
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
