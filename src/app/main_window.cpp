// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDir>
#include <QFileInfo>
#include <QLayout>
#include <QMenu>
#include <QScreen>
#include <QSessionManager>
#include <QSettings>
#include <QStatusBar>
#include <QStyle>
#include <QTimer>
#include <QVBoxLayout>

#include "analysis/freed_memory.h"
#include "app/actions/camera_actions.h"
#include "app/actions/display_actions.h"
#include "app/actions/edit_actions.h"
#include "app/actions/exchange_actions.h"
#include "app/actions/export_actions.h"
#include "app/actions/file_actions.h"
#include "app/actions/help_actions.h"
#include "app/actions/hit_actions.h"
#include "app/actions/inspect_actions.h"
#include "app/actions/mesh_actions.h"
#include "app/actions/picture_actions.h"
#include "app/actions/repeat_actions.h"
#include "app/actions/shot_actions.h"
#include "app/actions/theme_actions.h"
#include "app/actions/viewport_menu.h"
#include "app/dialogs/dialogs.h"
#include "app/dialogs/go_to_vertex.h"
#include "app/dialogs/mesh_locator.h"
#include "app/dialogs/texture_chooser.h"
#include "app/dialogs/texture_locator.h"
#include "app/discard_guard.h"
#include "app/full_view.h"
#include "app/help_tips.h"
#include "app/key_routing.h"
#include "app/mesh_reloader.h"
#include "app/notice_bar.h"
#include "app/overlays/coming_picture.h"
#include "app/overlays/start_card.h"
#include "app/overlays/time_badge.h"
#include "app/overlays/vertex_label.h"
#include "app/pipeline_chooser.h"
#include "app/recovery_bar.h"
#include "app/reload_bar.h"
#include "app/scene_files.h"
#include "app/session_collector.h"
#include "app/session_files.h"
#include "app/settings/settings_keeper.h"
#include "app/status_line.h"
#include "app/window/frame_rate_read_out.h"
#include "app/window/journal_keeping.h"
#include "app/window/window_docks.h"
#include "app/window/window_menus.h"
#include "document/journal_files.h"
#include "models/plain_text.h"
#include "viewport/aim_preview.h"
#include "viewport/handles/hit_handles.h"
#include "viewport/handles/target_handles.h"
#include "viewport/inspect_tool.h"
#include "viewport/surface/surface_format.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr int kMessageStays = 8'000;  // milliseconds in the status bar
constexpr int kHintStays = 20'000;    // milliseconds
constexpr int kEndsWithin = 4'000;    // milliseconds, for another window that is about to end

}  // namespace

void MainWindow::setSurfaceFormat() {
    QSurfaceFormat::setDefaultFormat(baseSurfaceFormat());
}

MainWindow::MainWindow(Session& session, QWidget* parent)
    : QMainWindow(parent),
      m_session(session),
      m_settings(loadAppSettings(QSettings())),
      m_hitEffects(session),
      m_viewport(new Viewport(session, this)),
      m_view(*m_viewport, m_actions),
      m_notice(new NoticeBar(this)),
      m_files(new SceneFiles(session, this)),
      m_sessions(new SessionFiles(session, m_view.functions(), this)),
      m_status(new StatusLine(session, *statusBar(), this)),
      m_guard(new DiscardGuard(session, *m_sessions, *this, [this] { return m_actions.file->save(); })),
      m_recovery(new RecoveryBar(*m_sessions, *m_guard, journalFolder(), this)),
      m_reloader(new MeshReloader(session, this)) {
    loadSessionSettings(QSettings(), session);
    m_viewport->setOptions(m_settings.display);
    m_actions.make({session, m_settings, m_hitEffects, *m_viewport, *m_files, *m_sessions, *m_guard,
                    *m_notice, m_view, *this});
    new HelpTips(this);
    new FreedMemory(session, giveBackFreedMemory, this);
    makeCentre();
    setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
    makeOverlays();
    m_files->setReadying([this](const ScenePlan& scene) { return m_viewport->scene().bringMeshes(scene); });
    connect(m_files, &SceneFiles::ended, &m_viewport->scene(), &ViewportScene::dropUnusedMeshes);
    m_menus = new WindowMenus(*this, *m_viewport, m_actions);
    m_docks = new WindowDocks(
        {session, m_settings, m_hitEffects, *m_viewport, *m_files, m_actions, *m_menus, *this});
    m_menus->makeToolBar();
    makeStartCard();
    m_actions.textureChooser->restore(m_settings.coverTexture);
    m_actions.cameras->load(QSettings());
    connectSession();
    connectMessages();
    connectViewport();
    restoreWindow();
    connectSettings();  // from here on, what is changed is the person's
    statusBar()->showMessage(tr("Click shoots, drag orbits, wheel zooms. F1 lists all keys."), kHintStays);
    m_viewport->setFocus();
}

MainWindow::~MainWindow() {
    delete m_journal;  // it asks how the window looks at the session
    hide();
    delete m_docks;  // before what its panels use
}

// Parts

/// The picture, with notices above it and the card of first steps below.
void MainWindow::makeCentre() {
    auto* centre = new QWidget(this);
    centre->setFocusProxy(m_viewport);
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins({});
    column->setSpacing(0);
    column->addWidget(new ReloadBar(*m_reloader, this));
    column->addWidget(m_recovery);
    column->addWidget(m_notice);
    column->addWidget(m_viewport, 1);
    setCentralWidget(centre);
}

/// What lies over the picture, and what takes keys and clicks before it.
void MainWindow::makeOverlays() {
    new VertexLabel(m_session, *m_viewport);
    new HitHandles(*m_viewport, m_session, m_actions.hits->editing());
    listenTo(new TargetHandles(*m_viewport, m_session));
    new KeyRouting(*this, *m_viewport);
    new TimeBadge(m_session, m_viewport);
    new ComingPicture(*m_files, *m_viewport);
}

void MainWindow::makeStartCard() {
    m_startCard = new StartCard({.inspect = m_actions.inspect->inspect(),
                                 .exportMesh = m_actions.exports->exportMesh(),
                                 .open = m_actions.file->open(),
                                 .samples = m_actions.file->scenes()},
                                this);
    centralWidget()->layout()->addWidget(m_startCard);
    QMenu& help = m_menus->help();
    help.insertAction(help.actions().value(1), m_startCard->toggle());
    m_startCard->follow(*m_viewport, m_session);
    connect(m_sessions, &SessionFiles::opened, m_startCard, [this] {
        if (m_session.hits().history().size() > 0) {  // who made them knows how
            m_startCard->dismiss();
        }
    });
}

void MainWindow::showFirstSteps() {
    m_guard->letGo();  // the first scene's dent is not the person's
    m_startCard->restore(QSettings());
}

// The session and its files

void MainWindow::connectSession() {
    m_guard->letGo();  // of what was there before the window
    connect(m_actions.exports, &ExportActions::began, m_guard, &DiscardGuard::exportBegins);
    connect(m_actions.exports, &ExportActions::ended, m_guard, &DiscardGuard::exportEnds);
    connect(m_actions.exports, &ExportActions::writing, m_reloader, &MeshReloader::hold);
    connect(m_actions.exports, &ExportActions::ended, m_reloader, &MeshReloader::release);
    connect(m_actions.hits, &HitActions::exportBegan, m_guard, &DiscardGuard::hitsExportBegins);
    connect(m_actions.hits, &HitActions::exported, m_guard, &DiscardGuard::hitsExported);
    m_journal = new JournalKeeping(m_session, *m_sessions, m_view, *m_viewport, this);
    connect(m_actions.cameras, &CameraActions::bookmarksChanged, m_journal, &JournalKeeping::viewChanged);
    connect(m_journal, &JournalKeeping::recoveredKept, m_recovery, &RecoveryBar::dropRecovered);
    new MeshLocator(*m_sessions, *this);
    connect(m_sessions, &SessionFiles::changed, this, &MainWindow::showTitle);
    connect(m_sessions, &SessionFiles::cancelled, this,
            [this] { say(tr("Cancelled. The session is unchanged.")); });
    connect(m_sessions, &SessionFiles::saveCancelled, this,
            [this] { say(tr("Cancelled. The file is unchanged.")); });
    connect(m_sessions, &SessionFiles::differs, this, [this](const QStringList& targets) {
        m_notice->say(
            tr("Not as it was saved: %1. This renderer makes other positions of the same hits; Help > "
               "Graphics tells whether it is exact.")
                .arg(targets.mid(0, 5).join(QStringLiteral(", "))));
    });
    connect(m_reloader, &MeshReloader::reloaded, this, [this](const QStringList& said) {
        m_journal->flush();  // the hits are on other targets: both together
        m_notice->say(said.join(u'\n'));
        m_reloads = m_session.steps().done();
    });
    connect(&m_session, &Session::undoChanged, this, [this] {
        if (m_reloads && m_session.steps().done() < *m_reloads) {  // what was said of it is untrue now
            m_reloads.reset();
            m_notice->clear();
        }
    });
    connect(m_reloader, &MeshReloader::cancelled, this,
            [this] { say(tr("Cancelled. The meshes are unchanged.")); });
    connect(&m_session, &Session::sceneReplaced, this, &MainWindow::followScene);
    followScene();
}

void MainWindow::followScene() {
    showTitle();
    m_notice->clear();
}

void MainWindow::showTitle() {
    const QString file = QFileInfo(m_sessions->path()).fileName();
    setWindowTitle((file.isEmpty() ? m_session.sceneName() : file) + QStringLiteral("[*]"));
    setWindowModified(m_sessions->isModified());
}

void MainWindow::offerRecovery() {
    m_recovery->look();
    // What ended a moment ago may still hold its journal.
    QTimer::singleShot(kEndsWithin, m_recovery, [this] { m_recovery->look(); });
}

void MainWindow::openFiles(const QStringList& paths) {
    m_actions.file->open(paths);
}

void MainWindow::beginExport(const QString& path, std::optional<NormalMode> normals) {
    m_actions.exports->begin(path, normals);
}

Status MainWindow::exportTo(const QString& path, std::optional<NormalMode> normals) {
    return m_actions.exports->write(path, normals);
}

Status MainWindow::savePictureTo(const QString& path) {
    return m_actions.pictures->save(path);
}

void MainWindow::placeMesh(double extent) {
    m_actions.file->place(extent);
}

// What is said

void MainWindow::say(const QString& text) {
    statusBar()->showMessage(text, kMessageStays);
    statusBar()->setToolTip(asPlainText(text));  // a narrow window has no room for all of it
}

void MainWindow::fail(const Error& error) {
    showError(this, error);
}

/// What a part has to say goes to the status bar, to the notice bar or into a message box.
template <class Part>
void MainWindow::listenTo(const Part* part) {
    static_assert(sizeof(Part) > 0, "of a class that is only declared, no signal would be found");
    if constexpr (requires { &Part::said; }) {
        connect(part, &Part::said, this, &MainWindow::say);
    }
    if constexpr (requires { &Part::noticeWanted; }) {
        connect(part, &Part::noticeWanted, this, [this](const QString& text) { m_notice->say(text); });
    }
    if constexpr (requires { &Part::failed; }) {
        connect(part, &Part::failed, this, &MainWindow::fail);
    }
}

void MainWindow::connectMessages() {
    const auto listenToAll = [this](const auto*... parts) { (listenTo(parts), ...); };
    const WindowActions& a = m_actions;
    listenToAll(a.cameras, a.collector, a.edit, a.exchange, a.exports, a.file, a.help, a.mesh, a.pictures,
                a.repeat, a.shots, a.textureLocator);
    listenToAll(m_docks, m_files, m_journal, m_recovery, m_reloader, m_sessions, m_viewport);
    connect(a.hits, &HitActions::failed, this, &MainWindow::fail);
    connect(a.hits, &HitActions::said, this,
            [this](const QString& text) { statusBar()->showMessage(text, kHintStays); });
    // The notice may name what has been found.
    connect(a.textureLocator, &TextureLocator::said, m_notice, &NoticeBar::clear);
    // Later: it is found out in the middle of drawing a frame.
    connect(
        a.pipelines, &PipelineChooser::fellBack, this,
        [this](const QString& notice) { m_notice->say(notice); }, Qt::QueuedConnection);
}

void MainWindow::connectViewport() {
    const auto lookAtAdded = [this](SceneFiles::Into into) {
        if (into == SceneFiles::Into::ThisScene) {
            m_viewport->bringSelectionIntoSight();
        }
    };
    connect(m_files, &SceneFiles::opened, this,
            [lookAtAdded](const auto&, const auto&, SceneFiles::Into into) { lookAtAdded(into); });
    connect(m_files, &SceneFiles::made, this,
            [lookAtAdded](const auto&, SceneFiles::Into into) { lookAtAdded(into); });
    const InspectTool& tool = m_viewport->inspectTool();
    connect(&tool, &InspectTool::toolChanged, this,
            [this, &tool] { m_actions.shots->aimPreview().setClicksShoot(tool.tool() == Tool::Shoot); });
    auto* menu = new ViewportMenu(m_session, *m_viewport, this);
    connect(menu, &ViewportMenu::dockWanted, m_docks, &WindowDocks::show);
    connect(m_actions.goToVertex, &GoToVertex::arrived, this,
            [this] { m_docks->show(QStringLiteral("vertexChanges")); });
    connect(&m_viewport->scene(), &ViewportScene::made, this, [this] {
        m_status->setRenderer(m_viewport->scene().rendererName());
        m_actions.pipelines->leaveInexact();
    });
    new FrameRateReadOut(m_docks->frameRate(), *m_viewport, *m_status, m_docks);
}

void MainWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_actions.themes != nullptr) {
        m_actions.themes->followWindow();
    }
}

// What outlives the window, and how it ends

void MainWindow::connectSettings() {
    connect(m_actions.display, &DisplayActions::normalsChanged, this,
            [this] { m_settings.exportNormals.reset(); });  // export follows the screen again
    m_keeper = new SettingsKeeper([this](QSettings& settings) { saveSettings(settings); }, this);
    connect(m_actions.file, &FileActions::opened, m_keeper, &SettingsKeeper::lookSoon);
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

void MainWindow::restoreWindow() {
    m_actions.themes->followWindow();
    // On a small screen no part of it is out of sight; the desktop's frame, not known yet, comes on top.
    const int frame = style()->pixelMetric(QStyle::PM_TitleBarHeight);
    const QSize wanted = QSize(1440, 900).boundedTo(screen()->availableSize() - QSize(0, frame));
    if (minimumHeight() > wanted.height()) {
        layout()->activate();  // it is from before docks shared places
    }
    resize(wanted);
    m_docks->restore(QSettings());
    connect(m_menus, &WindowMenus::resetLayoutWanted, m_docks, &WindowDocks::reset);
}

void MainWindow::saveSettings(QSettings& settings) {
    m_docks->save(settings);
    m_actions.cameras->save(settings);
    m_settings.display = m_viewport->options();
    m_settings.coverTexture = m_actions.textureChooser->chosen();
    saveAppSettings(settings, m_settings);
    m_actions.hits->save(settings);
    saveSessionSettings(settings, m_session);
    m_actions.inspect->save(settings);
    m_actions.repeat->save(settings);
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
    m_actions.fullView->set(false);
    m_keeper->saveNow();
}

}  // namespace hitscope
