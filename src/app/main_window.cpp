// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"

#include <QAction>
#include <QActionGroup>
#include <QCloseEvent>
#include <QDockWidget>
#include <QMenu>
#include <QScreen>
#include <QSettings>
#include <QStatusBar>
#include <QSurfaceFormat>
#include <algorithm>

#include "app/dialogs.h"
#include "app/notice_bar.h"
#include "app/pipeline_chooser.h"
#include "app/scene_files.h"
#include "app/shading_actions.h"
#include "app/shot_actions.h"
#include "app/status_line.h"
#include "app/texture_chooser.h"
#include "app/time_actions.h"
#include "app/time_badge.h"
#include "models/undo_text.h"
#include "panels/deformation_constants/deformation_constants_panel.h"
#include "panels/dent_measurement/dent_measurement_panel.h"
#include "panels/frame_rate/cost_view.h"
#include "panels/frame_rate/frame_rate_panel.h"
#include "panels/hit_history/hit_history_panel.h"
#include "panels/lights/lights_panel.h"
#include "panels/mesh_statistics/mesh_statistics_panel.h"
#include "panels/scene/scene_panel.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr int kFrameRateInterval = 500;  // milliseconds between read-outs in the status bar
constexpr int kHintStays = 20'000;       // milliseconds
constexpr int kLayoutVersion = 3;        // docks that are gone or new make an old layout useless

}  // namespace

void MainWindow::setSurfaceFormat() {
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    QSurfaceFormat::setDefaultFormat(format);
}

MainWindow::MainWindow(Session& session, QWidget* parent)
    : QMainWindow(parent),
      m_session(session),
      m_settings(loadAppSettings(QSettings())),
      m_hitHistory(session),
      m_meshStatistics(session),
      m_scene(session),
      m_viewport(new Viewport(session, this)),
      m_notice(new NoticeBar(m_viewport)),
      m_files(new SceneFiles(session, this)),
      m_status(new StatusLine(session, *statusBar(), this)),
      m_time(new TimeActions(session, this)),
      m_shots(new ShotActions(session, *m_viewport, *this)),
      m_pipelines(new PipelineChooser(session, this)) {
    loadSessionSettings(QSettings(), session);
    applyTheme(m_settings.theme);
    m_viewport->setOptions(m_settings.display);
    setCentralWidget(m_viewport);
    setAcceptDrops(true);
    setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
    makeMenus();
    makeDocks();
    makeToolBar();
    new TimeBadge(session, m_viewport);
    m_textureChooser->choose(m_settings.coverTexture);
    connectFiles();

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
    connect(m_shots, &ShotActions::noticeWanted, this, [this](const QString& text) { m_notice->say(text); });
    connect(m_viewport, &Viewport::rendererKnown, this,
            [this] { m_status->setRenderer(m_viewport->rendererName()); });
    connect(m_viewport, &Viewport::failed, this, [this](const Error& error) { showError(this, error); });
    connect(&m_frameRateTimer, &QTimer::timeout, this,
            [this] { m_status->setFrameRate(m_frameRate->summary().framesPerSecond); });
    m_frameRateTimer.start(kFrameRateInterval);

    followScene();
    followDisplay();
    followLights();
    followViewportTheme();
    restoreWindow();
    statusBar()->showMessage(tr("Click shoots, drag orbits, wheel zooms. F1 lists all keys."), kHintStays);
    m_viewport->setFocus();
}

MainWindow::~MainWindow() = default;

QDockWidget* MainWindow::addDock(const QString& name, const QString& title, QWidget* panel,
                                 Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    dock->setWidget(panel);
    addDockWidget(area, dock);
    m_docksMenu->addAction(dock->toggleViewAction());
    return dock;
}

void MainWindow::makeDocks() {
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
    m_frameRate = new FrameRatePanel(m_session, *m_continuous);
    m_frameRate->costs().setCamera([this] { return m_viewport->camera(); });
    QDockWidget* statistics =
        addDock(QStringLiteral("meshStatistics"), tr("Mesh statistics"),
                new MeshStatisticsPanel(m_session, m_meshStatistics), Qt::RightDockWidgetArea);
    QDockWidget* scene = makeSceneDock();
    QDockWidget* history = addDock(QStringLiteral("hitHistory"), tr("Hit history"),
                                   new HitHistoryPanel(m_session, m_hitHistory), Qt::BottomDockWidgetArea);
    QDockWidget* constants = addDock(QStringLiteral("deformationConstants"), tr("Deformation constants"),
                                     new DeformationConstantsPanel(m_session), Qt::RightDockWidgetArea);
    QDockWidget* lights =
        addDock(QStringLiteral("lights"), tr("Lights"), new LightsPanel(m_session), Qt::RightDockWidgetArea);
    QDockWidget* frameRate =
        addDock(QStringLiteral("frameRate"), tr("Frame rate"), m_frameRate, Qt::BottomDockWidgetArea);
    QDockWidget* dent = addDock(QStringLiteral("dentMeasurement"), tr("Dent measurement"),
                                new DentMeasurementPanel(m_session), Qt::RightDockWidgetArea);
    tabifyDockWidget(statistics, scene);
    tabifyDockWidget(scene, dent);
    statistics->raise();
    tabifyDockWidget(constants, lights);
    constants->raise();
    resizeDocks({statistics, constants}, {350, 350}, Qt::Horizontal);
    resizeDocks({statistics, constants}, {420, 170}, Qt::Vertical);
    resizeDocks({history, frameRate}, {190, 190}, Qt::Vertical);
    resizeDocks({history, frameRate}, {620, 380}, Qt::Horizontal);
}

QDockWidget* MainWindow::makeSceneDock() {
    auto* panel = new ScenePanel(m_session, m_scene);
    connect(panel, &ScenePanel::filesWanted, this, &MainWindow::chooseAddition);
    connect(panel, &ScenePanel::targetWanted, this,
            [this](const QString& name, const std::function<TargetPlan()>& make) {
                m_files->make(name, SceneFiles::Into::ThisScene, [make] { return ScenePlan{{}, {make()}}; });
            });
    m_viewport->addActions(panel->targetActions());
    QAction* first = m_meshMenu->actions().constFirst();
    m_meshMenu->insertMenu(first, panel->addMenu());
    m_meshMenu->insertSeparator(first);
    return addDock(QStringLiteral("scene"), tr("Scene"), panel, Qt::RightDockWidgetArea);
}

void MainWindow::restoreWindow() {
    // On a small screen no part of it is out of sight at first.
    resize(QSize(1440, 900).boundedTo(screen()->availableSize()));
    m_firstLayout = saveState(kLayoutVersion);
    const QSettings settings;
    m_frameRate->restoreState(settings.value(QStringLiteral("window/frameRate")).toByteArray());
    restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
    restoreState(settings.value(QStringLiteral("window/layout")).toByteArray(), kLayoutVersion);
}

void MainWindow::resetLayout() {
    restoreState(m_firstLayout, kLayoutVersion);
}

void MainWindow::saveSettings() {
    QSettings settings;
    settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
    settings.setValue(QStringLiteral("window/layout"), saveState(kLayoutVersion));
    settings.setValue(QStringLiteral("window/frameRate"), m_frameRate->saveState());
    m_settings.display = m_viewport->options();
    m_settings.coverTexture = m_textureChooser->chosen();
    saveAppSettings(settings, m_settings);
    saveSessionSettings(settings, m_session);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    m_files->cancel();
    saveSettings();
    event->accept();
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
    m_placeMesh->setEnabled(oneMesh);
    m_fileCoordinates->setEnabled(oneMesh &&
                                  !m_session.targets().front()->deformed.original().placement.isIdentity());
    m_export->setEnabled(!m_session.targets().empty());
}

void MainWindow::followHistory() {
    const auto name = [](QAction& action, const QString& text, const auto& step) {
        action.setEnabled(step.has_value());
        action.setText(step ? text + u' ' + undoText(*step) : text);
    };
    name(*m_undo, tr("&Undo"), m_session.undoName());
    name(*m_redo, tr("&Redo"), m_session.redoName());
    m_enableAll->setEnabled(m_session.disabledHits() > 0);
    m_clear->setEnabled(m_session.history().size() > 0);
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
