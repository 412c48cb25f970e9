// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"

#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QMenu>
#include <QSettings>
#include <QStatusBar>
#include <algorithm>

#include "analysis/hit_effects.h"
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
#include "app/actions/viewport_menu.h"
#include "app/dialogs/dialogs.h"
#include "app/dialogs/go_to_vertex.h"
#include "app/dialogs/texture_chooser.h"
#include "app/dialogs/texture_locator.h"
#include "app/full_view.h"
#include "app/help_tips.h"
#include "app/key_routing.h"
#include "app/notice_bar.h"
#include "app/pipeline_chooser.h"
#include "app/scene_files.h"
#include "app/status_line.h"
#include "app/time_badge.h"
#include "app/vertex_label.h"
#include "models/undo_text.h"
#include "panels/frame_rate/frame_rate_panel.h"
#include "panels/help/help_text.h"
#include "viewport/aim_preview.h"
#include "viewport/hit_handles.h"
#include "viewport/inspect_tool.h"
#include "viewport/surface_format.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr int kFrameRateInterval = 500;  // milliseconds between read-outs in the status bar
constexpr int kHintStays = 20'000;       // milliseconds

}  // namespace

void MainWindow::setSurfaceFormat() {
    QSurfaceFormat::setDefaultFormat(baseSurfaceFormat());
}

MainWindow::MainWindow(Session& session, QWidget* parent)
    : QMainWindow(parent),
      m_session(session),
      m_settings(loadAppSettings(QSettings())),
      m_hitEffects(session),
      m_hitHistory(session, &m_hitEffects),
      m_meshStatistics(session),
      m_scene(session),
      m_viewport(new Viewport(session, this)),
      m_notice(new NoticeBar(this)),
      m_files(new SceneFiles(session, this)),
      m_hitActions(new HitActions(session, m_hitEffects, m_settings.folder, this)),
      m_status(new StatusLine(session, *statusBar(), this)),
      m_time(new TimeActions(session, this)),
      m_shots(new ShotActions(session, *m_viewport, *this)),
      m_pipelines(new PipelineChooser(session, this)),
      m_cameraActions(new CameraActions(*m_viewport, this)),
      m_pictures(new PictureActions(*m_viewport, *this)),
      m_fullView(new FullView(*this)),
      m_inspect(new InspectActions(session, *m_viewport, this)),
      m_goToVertex(new GoToVertex(session, *m_viewport, this)),
      m_help(new HelpActions(session, *m_viewport, this)),
      m_viewportMenu(new ViewportMenu(session, *m_viewport, this)) {
    new HelpTips(this);
    loadSessionSettings(QSettings(), session);
    applyTheme(m_settings.theme);
    m_viewport->setOptions(m_settings.display);
    m_change = new ChangeActions(session, m_hitEffects, *m_viewport, this);
    m_cut = new CutActions(session, m_change->comparison(), *m_viewport, this);
    makeCentre();
    setAcceptDrops(true);
    setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
    new VertexLabel(session, *m_viewport);
    new HitHandles(*m_viewport, session, m_hitActions->editing());
    new KeyRouting(*this, *m_viewport);
    makeMenus();
    makeDocks();
    makeToolBar();
    makeStartCard();
    new TimeBadge(session, m_viewport);
    m_textureChooser->choose(m_settings.coverTexture);
    connectFiles();
    connectCameraAndPictures();
    connectPicking();

    connect(&session, &Session::sceneReplaced, this, &MainWindow::followScene);
    connect(&session, &Session::targetAdded, this, &MainWindow::followTargets);
    connect(&session, &Session::targetRemoved, this, &MainWindow::followTargets);
    connect(&session, &Session::undoChanged, this, &MainWindow::followHistory);
    connect(&session, &Session::hitsAppended, this, &MainWindow::followHistory);
    connect(&session, &Session::historyReset, this, &MainWindow::followHistory);
    connect(&session, &Session::lightsChanged, this, &MainWindow::followLights);
    // Later: it is found out in the middle of drawing a frame.
    connect(
        m_pipelines, &PipelineChooser::fellBack, this,
        [this](const QString& notice) { m_notice->say(notice); }, Qt::QueuedConnection);
    const InspectTool& tool = m_viewport->inspectTool();
    connect(&tool, &InspectTool::toolChanged, this,
            [this, &tool] { m_shots->aimPreview().setClicksShoot(tool.tool() == Tool::Shoot); });
    connect(m_shots, &ShotActions::said, this,
            [this](const QString& text) { statusBar()->showMessage(text, kMessageStays); });
    connect(m_shots, &ShotActions::noticeWanted, this, [this](const QString& text) { m_notice->say(text); });
    connect(m_hitActions, &HitActions::said, this,
            [this](const QString& text) { statusBar()->showMessage(text, kHintStays); });
    connect(m_hitActions, &HitActions::failed, this, [this](const Error& error) { showError(this, error); });
    connect(m_viewport, &Viewport::rendererKnown, this, [this] {
        m_status->setRenderer(m_viewport->rendererName());
        m_pipelines->leaveInexact();
    });
    connect(m_viewport, &Viewport::failed, this, [this](const Error& error) { showError(this, error); });
    connect(&m_frameRateTimer, &QTimer::timeout, this, &MainWindow::followFrameRate);
    m_frameRateTimer.setInterval(kFrameRateInterval);
    connect(&session.frameCosts(), &FrameCosts::frameEnded, this, [this] {
        if (!m_frameRateTimer.isActive()) {
            m_frameRateTimer.start();
        }
    });

    followScene();
    followDisplay();
    followLights();
    followViewportTheme();
    restoreWindow();
    statusBar()->showMessage(tr("Click shoots, drag orbits, wheel zooms. F1 lists all keys."), kHintStays);
    m_viewport->setFocus();
}

void MainWindow::followFrameRate() {
    const FrameTimes::Summary summary = m_frameRate->summary();
    m_status->setFrameRate(summary);
    if (summary.recent == 0) {
        m_frameRateTimer.stop();  // until the next frame
    }
}

MainWindow::~MainWindow() {
    // The panels go before the models that they show, which are members.
    hide();
    qDeleteAll(findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly));
}

void MainWindow::connectCameraAndPictures() {
    connect(m_cameraActions, &CameraActions::said, this,
            [this](const QString& text) { statusBar()->showMessage(text, kMessageStays); });
    connect(m_cameraActions, &CameraActions::failed, this,
            [this](const Error& error) { showError(this, error); });
    m_cameraActions->load(QSettings());
    connect(m_pictures, &PictureActions::said, this,
            [this](const QString& text) { statusBar()->showMessage(text, kMessageStays); });
    connect(m_pictures, &PictureActions::failed, this,
            [this](const Error& error) { showError(this, error); });
}

void MainWindow::connectPicking() {
    connect(m_textureLocator, &TextureLocator::said, this, [this](const QString& text) {
        m_notice->clear();  // it may name what has been found
        statusBar()->showMessage(text, kMessageStays);
    });
    connect(m_textureLocator, &TextureLocator::failed, this,
            [this](const Error& error) { showError(this, error); });
    connect(m_help, &HelpActions::failed, this, [this](const Error& error) { showError(this, error); });
    connect(m_goToVertex, &GoToVertex::arrived, this, [this] { showDock(QStringLiteral("vertexChanges")); });
    connect(m_viewportMenu, &ViewportMenu::dockWanted, this, &MainWindow::showDock);
}

void MainWindow::showDock(const QString& name) {
    if (auto* dock = findChild<QDockWidget*>(name)) {
        dock->show();
        dock->raise();
    }
}

void MainWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_viewport != nullptr) {
        followViewportTheme();
    }
}

void MainWindow::followScene() {
    setWindowTitle(m_session.sceneName());
    m_notice->clear();
    followTargets();
    followHistory();
}

void MainWindow::followTargets() {
    const bool oneMesh = m_session.targets().size() == 1;
    const QString onlyOne = tr("This is for scenes of one mesh.");
    enableIf(*m_placeMesh, oneMesh, onlyOne);
    enableIf(*m_fileCoordinates,
             oneMesh && !m_session.targets().front()->deformed.original().placement.isIdentity(),
             oneMesh ? tr("The mesh has its file's own coordinates.") : onlyOne);
    enableIf(*m_export, !m_session.targets().empty(), tr("There is no target to export."));
}

void MainWindow::followHistory() {
    const auto name = [](QAction& action, const QString& text, const auto& step, const QString& why) {
        enableIf(action, step.has_value(), why);
        action.setText(step ? text + u' ' + undoText(*step) : text);
    };
    name(*m_undo, tr("&Undo"), m_session.undoName(), tr("There is nothing to undo."));
    name(*m_redo, tr("&Redo"), m_session.redoName(), tr("There is nothing to redo."));
    enableIf(*m_enableAll, m_session.disabledHits() > 0, tr("No hit is disabled."));
    enableIf(*m_clear, m_session.history().size() > 0, tr("There are no hits yet."));
}

void MainWindow::followDisplay() {
    const DisplayOptions& display = m_viewport->options();
    m_wireframes[static_cast<std::size_t>(display.wireframe)]->setChecked(true);
    m_normals[static_cast<std::size_t>(display.normals)]->setChecked(true);
    m_textures->setChecked(display.textures);
    m_floor->setChecked(display.floor);
    m_crosshair->setChecked(display.crosshair);
    m_shading->show(display);
}

void MainWindow::followLights() {
    const Lights& lights = m_session.lights();
    m_lights[0]->setChecked(lights.directional.on);
    m_lights[1]->setChecked(std::any_of(lights.points.begin(), lights.points.end(),
                                        [](const PointLight& light) { return light.on; }));
    m_lights[2]->setChecked(lights.spot.on);
}

void MainWindow::followViewportTheme() {
    DisplayOptions display = m_viewport->options();
    display.theme = m_settings.viewportTheme.value_or(isDark(palette()) ? Theme::Dark : Theme::Light);
    m_viewport->setOptions(display);
}

void MainWindow::changeDisplay(const std::function<void(DisplayOptions&)>& change) {
    DisplayOptions display = m_viewport->options();
    change(display);
    if (display.normals != m_viewport->options().normals) {
        m_settings.exportNormals.reset();  // export follows the screen again
    }
    m_viewport->setOptions(display);
    followDisplay();
}

void MainWindow::cycleWireframe() {
    changeDisplay([](DisplayOptions& display) {
        display.wireframe = static_cast<WireframeMode>((static_cast<int>(display.wireframe) + 1) % 3);
    });
}

void MainWindow::toggleLight(const std::function<void(Lights&)>& change) {
    Lights lights = m_session.lights();
    change(lights);
    m_session.setLights(lights);
}

void MainWindow::chooseTheme(ThemeChoice choice) {
    m_settings.theme = choice;
    applyTheme(choice);
    followViewportTheme();
}

}  // namespace hitscope
