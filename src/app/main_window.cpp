// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDir>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMenu>
#include <QMimeData>
#include <QScreen>
#include <QSessionManager>
#include <QSettings>
#include <QStatusBar>
#include <QStyle>
#include <QVBoxLayout>

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
#include "app/actions/picture_actions.h"
#include "app/actions/repeat_actions.h"
#include "app/actions/shot_actions.h"
#include "app/actions/theme_actions.h"
#include "app/actions/time_actions.h"
#include "app/actions/viewport_menu.h"
#include "app/dialogs/dialogs.h"
#include "app/dialogs/go_to_vertex.h"
#include "app/dialogs/texture_chooser.h"
#include "app/dialogs/texture_locator.h"
#include "app/discard_guard.h"
#include "app/full_view.h"
#include "app/help_tips.h"
#include "app/key_routing.h"
#include "app/notice_bar.h"
#include "app/overlays/coming_picture.h"
#include "app/overlays/start_card.h"
#include "app/overlays/time_badge.h"
#include "app/overlays/vertex_label.h"
#include "app/pipeline_chooser.h"
#include "app/recovery_bar.h"
#include "app/scene_files.h"
#include "app/session_files.h"
#include "app/settings/settings_keeper.h"
#include "app/status_line.h"
#include "document/journal_files.h"
#include "document/session_journal.h"
#include "panels/frame_rate/frame_rate_panel.h"
#include "panels/mesh_statistics/mesh_statistics_panel.h"
#include "session/frame_costs.h"
#include "viewport/aim_preview.h"
#include "viewport/hit_handles.h"
#include "viewport/inspect_tool.h"
#include "viewport/surface_format.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr int kFrameRateInterval = 500;  // milliseconds between read-outs in the status bar
constexpr int kMessageStays = 8'000;     // milliseconds in the status bar
constexpr int kHintStays = 20'000;       // milliseconds
constexpr int kLayoutVersion = 6;        // docks that are gone or new make an old layout useless

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
      m_sessions(new SessionFiles(session, view(), this)),
      m_status(new StatusLine(session, *statusBar(), this)),
      m_textureChooser(new TextureChooser(session, this)),
      m_textureLocator(new TextureLocator(session, this)),
      m_pipelines(new PipelineChooser(session, this)),
      m_fullView(new FullView(*this)),
      m_viewportMenu(new ViewportMenu(session, *m_viewport, this)),
      m_goToVertex(new GoToVertex(session, *m_viewport, this)),
      m_hitActions(new HitActions(session, m_hitEffects, m_settings.folder, this)),
      m_exports(new ExportActions(session, *m_viewport, m_settings, *this)),
      m_guard(new DiscardGuard(session, *m_sessions, *this, [this] { return m_fileActions->save(); })),
      m_recovery(new RecoveryBar(*m_sessions, *m_guard, journalFolder(), this)),
      m_fileActions(new FileActions(
          {session, m_settings, *m_files, *m_sessions, *m_guard, *m_textureLocator, *m_notice, *this})),
      m_edit(new EditActions(session, this)),
      m_display(new DisplayActions(*m_viewport, *m_textureChooser, this)),
      m_themes(new ThemeActions(m_settings, *m_viewport, this)),
      m_lights(new LightActions(session, this)),
      m_time(new TimeActions(session, this)),
      m_shots(new ShotActions(session, *m_viewport, *this)),
      m_cameraActions(new CameraActions(*m_viewport, this)),
      m_pictures(new PictureActions(*m_viewport, *this)),
      m_exchange(
          new ExchangeActions({*m_viewport, *m_fileActions, *m_hitActions, *m_shots, *m_cameraActions,
                               *m_exports, [this] { return captureSession(m_session, view().capture()); }},
                              this)),
      m_inspect(new InspectActions(session, *m_viewport, this)),
      m_repeat(new RepeatActions(session, *m_viewport, m_hitActions->editing(), *this)),
      m_help(new HelpActions(session, *m_viewport, this)) {
    new HelpTips(this);
    loadSessionSettings(QSettings(), session);
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
    new ComingPicture(*m_files, *m_viewport);
    m_textureChooser->restore(m_settings.coverTexture);
    m_cameraActions->load(QSettings());
    connectFiles();
    connectMessages();
    connectViewport();
    connect(&session, &Session::sceneReplaced, this, &MainWindow::followScene);
    followScene();
    m_themes->followWindow();
    restoreWindow();
    statusBar()->showMessage(tr("Click shoots, drag orbits, wheel zooms. F1 lists all keys."), kHintStays);
    m_viewport->setFocus();
}

MainWindow::~MainWindow() {
    delete m_journal;  // it asks how the window looks at the session
    // The panels go before the models that they show, which are members.
    hide();
    qDeleteAll(findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly));
}

/// The picture, with notices above it and the card of first steps below.
void MainWindow::makeCentre() {
    auto* centre = new QWidget(this);
    centre->setFocusProxy(m_viewport);
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins({});
    column->setSpacing(0);
    column->addWidget(m_recovery);
    column->addWidget(m_notice);
    column->addWidget(m_viewport, 1);
    setCentralWidget(centre);
}

void MainWindow::makeStartCard() {
    m_startCard = new StartCard({.inspect = m_inspect->inspect(),
                                 .exportMesh = m_exports->exportMesh(),
                                 .open = m_fileActions->open(),
                                 .samples = m_fileActions->scenes()},
                                this);
    centralWidget()->layout()->addWidget(m_startCard);
    m_helpMenu->insertAction(m_helpMenu->actions().value(1), m_startCard->toggle());
    connect(m_viewport, &Viewport::shot, m_startCard, &StartCard::dismiss);
}

void MainWindow::showFirstSteps() {
    m_guard->letGo();  // the first scene's dent is not the person's
    m_startCard->restore(QSettings());
}

// Files

void MainWindow::connectFiles() {
    m_guard->letGo();  // of what was there before the window
    connect(m_exports, &ExportActions::began, m_guard, &DiscardGuard::exportBegins);
    connect(m_exports, &ExportActions::ended, m_guard, &DiscardGuard::exportEnds);
    connect(m_hitActions, &HitActions::exportBegan, m_guard, &DiscardGuard::hitsExportBegins);
    connect(m_hitActions, &HitActions::exported, m_guard, &DiscardGuard::hitsExported);
    connectSession();
    connect(m_display, &DisplayActions::normalsChanged, this,
            [this] { m_settings.exportNormals.reset(); });  // export follows the screen again
    m_keeper = new SettingsKeeper([this](QSettings& settings) { saveSettings(settings); }, this);
    connect(m_fileActions, &FileActions::opened, m_keeper, &SettingsKeeper::lookSoon);
    connect(m_keeper, &SettingsKeeper::failed, this, [this](const QString& file) {
        m_notice->say(
            tr("Settings cannot be saved: %1 cannot be written. Changes last until the window is closed.")
                .arg(QDir::toNativeSeparators(file)));
    });
    // Directly: the desktop waits for the answer.
    connect(
        qApp, &QGuiApplication::commitDataRequest, this,
        [this](QSessionManager& manager) {
            m_keeper->saveNow();
            m_guard->answer(manager);
        },
        Qt::DirectConnection);
}

void MainWindow::openFiles(const QStringList& paths) {
    m_fileActions->open(paths);
}

void MainWindow::beginExport(const QString& path, std::optional<NormalMode> normals) {
    m_exports->begin(path, normals);
}

Status MainWindow::exportTo(const QString& path, std::optional<NormalMode> normals) {
    return m_exports->write(path, normals);
}

Status MainWindow::savePictureTo(const QString& path) {
    return m_pictures->save(path);
}

void MainWindow::placeMesh(double extent) {
    m_fileActions->place(extent);
}

/// What is dragged out of the window does not come in again.
void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->source() == nullptr && ExchangeActions::canTake(*event->mimeData())) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event) {
    if (event->source() != nullptr || !ExchangeActions::canTake(*event->mimeData())) {
        return;
    }
    event->acceptProposedAction();
    activateWindow();
    // Later: the program that was dragged from waits for the drop's end.
    auto dropped = std::make_shared<QMimeData>();
    dropped->setUrls(event->mimeData()->urls());
    QMetaObject::invokeMethod(
        this, [this, dropped] { m_exchange->take(*dropped); }, Qt::QueuedConnection);
}

// What is said

void MainWindow::say(const QString& text) {
    statusBar()->showMessage(text, kMessageStays);
}

void MainWindow::fail(const Error& error) {
    showError(this, error);
}

void MainWindow::connectMessages() {
    connect(m_fileActions, &FileActions::said, this, &MainWindow::say);
    connect(m_exports, &ExportActions::said, this, &MainWindow::say);
    connect(m_shots, &ShotActions::said, this, &MainWindow::say);
    connect(m_cameraActions, &CameraActions::said, this, &MainWindow::say);
    connect(m_pictures, &PictureActions::said, this, &MainWindow::say);
    connect(m_exchange, &ExchangeActions::said, this, &MainWindow::say);
    connect(m_hitActions, &HitActions::said, this,
            [this](const QString& text) { statusBar()->showMessage(text, kHintStays); });
    connect(m_textureLocator, &TextureLocator::said, this, [this](const QString& text) {
        m_notice->clear();  // it may name what has been found
        say(text);
    });
    connect(m_shots, &ShotActions::noticeWanted, this, [this](const QString& text) { m_notice->say(text); });
    connect(m_exports, &ExportActions::noticeWanted, this,
            [this](const QString& text) { m_notice->say(text); });
    // Later: it is found out in the middle of drawing a frame.
    connect(
        m_pipelines, &PipelineChooser::fellBack, this,
        [this](const QString& notice) { m_notice->say(notice); }, Qt::QueuedConnection);
    connect(m_files, &SceneFiles::failed, this, &MainWindow::fail);
    connect(m_sessions, &SessionFiles::failed, this, &MainWindow::fail);
    connect(m_exports, &ExportActions::failed, this, &MainWindow::fail);
    connect(m_hitActions, &HitActions::failed, this, &MainWindow::fail);
    connect(m_cameraActions, &CameraActions::failed, this, &MainWindow::fail);
    connect(m_repeat, &RepeatActions::said, this, &MainWindow::say);
    connect(m_repeat, &RepeatActions::failed, this, &MainWindow::fail);
    connect(m_pictures, &PictureActions::failed, this, &MainWindow::fail);
    connect(m_exchange, &ExchangeActions::failed, this, &MainWindow::fail);
    connect(m_textureLocator, &TextureLocator::failed, this, &MainWindow::fail);
    connect(m_help, &HelpActions::failed, this, &MainWindow::fail);
    connect(m_viewport, &Viewport::failed, this, &MainWindow::fail);
}

void MainWindow::connectViewport() {
    const InspectTool& tool = m_viewport->inspectTool();
    connect(&tool, &InspectTool::toolChanged, this,
            [this, &tool] { m_shots->aimPreview().setClicksShoot(tool.tool() == Tool::Shoot); });
    connect(m_goToVertex, &GoToVertex::arrived, this, [this] { showDock(QStringLiteral("vertexChanges")); });
    connect(m_viewportMenu, &ViewportMenu::dockWanted, this, &MainWindow::showDock);
    connect(m_viewport, &Viewport::rendererKnown, this, [this] {
        m_status->setRenderer(m_viewport->rendererName());
        m_pipelines->leaveInexact();
    });
    connect(&m_frameRateTimer, &QTimer::timeout, this, &MainWindow::followFrameRate);
    m_frameRateTimer.setInterval(kFrameRateInterval);
    connect(&m_session.frameCosts(), &FrameCosts::frameEnded, this, [this] {
        if (!m_frameRateTimer.isActive()) {
            m_frameRateTimer.start();
        }
    });
}

void MainWindow::followFrameRate() {
    const FrameTimes::Summary summary = m_frameRate->summary();
    m_status->setFrameRate(summary, m_viewport->motion().lastDetail());
    if (summary.recent == 0) {
        m_frameRateTimer.stop();  // until the next frame
    }
}

void MainWindow::followScene() {
    showTitle();
    m_notice->clear();
}

void MainWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_themes != nullptr) {
        m_themes->followWindow();
    }
}

// What outlives the window, and how it ends

void MainWindow::restoreWindow() {
    // On a small screen no part of it is out of sight at first.
    // The desktop's frame comes on top, and is not known before it does.
    const int frame = style()->pixelMetric(QStyle::PM_TitleBarHeight);
    resize(QSize(1440, 900).boundedTo(screen()->availableSize() - QSize(0, frame)));
    m_firstLayout = saveState(kLayoutVersion);
    const QSettings settings;
    m_frameRate->restoreState(settings.value(QStringLiteral("window/frameRate")).toByteArray());
    m_statisticsPanel->restoreState(settings.value(QStringLiteral("window/meshStatistics")).toByteArray());
    restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
    restoreState(settings.value(QStringLiteral("window/layout")).toByteArray(), kLayoutVersion);
}

void MainWindow::resetLayout() {
    restoreState(m_firstLayout, kLayoutVersion);
}

void MainWindow::saveSettings(QSettings& settings) {
    if (!m_fullView->isOn()) {  // what is remembered is the window with all its parts
        settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
        settings.setValue(QStringLiteral("window/layout"), saveState(kLayoutVersion));
    }
    settings.setValue(QStringLiteral("window/frameRate"), m_frameRate->saveState());
    settings.setValue(QStringLiteral("window/meshStatistics"), m_statisticsPanel->saveState());
    m_cameraActions->save(settings);
    m_settings.display = m_viewport->options();
    m_settings.coverTexture = m_textureChooser->chosen();
    m_settings.stretchLimit = static_cast<double>(m_meshStatistics.measuring().stretchLimit());
    saveAppSettings(settings, m_settings);
    m_hitActions->save(settings);
    saveSessionSettings(settings, m_session);
    m_inspect->save(settings);
    m_repeat->save(settings);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (m_guard->isAtRisk()) {
        event->ignore();
        m_guard->ask([this] {
            m_guard->letGo();
            close();
        });
        return;
    }
    m_journal->finish();
    endInOrder();
    event->accept();
}

void MainWindow::endInOrder() {
    m_files->cancel();
    m_sessions->cancel();
    m_fullView->set(false);
    m_keeper->saveNow();
}

}  // namespace hitscope
