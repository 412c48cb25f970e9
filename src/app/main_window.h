// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>
#include <QTimer>
#include <optional>

#include "analysis/hit_effects.h"
#include "app/session_files.h"
#include "app/settings/app_settings.h"
#include "models/hit_history_model.h"
#include "models/mesh_statistics_model.h"
#include "models/scene_model.h"
#include "session/session.h"

class QDockWidget;
class QSettings;
class QMenu;

namespace hitscope {

class CameraActions;
class ChangeActions;
class CutActions;
class DiscardGuard;
class DisplayActions;
class EditActions;
class ExchangeActions;
class ExportActions;
class FileActions;
class FrameRatePanel;
class FullView;
class GoToVertex;
class HelpActions;
class HitActions;
class HitHistoryPanel;
class InspectActions;
class LightActions;
class MeshStatisticsPanel;
class NoticeBar;
class PictureActions;
class PipelineChooser;
class SceneFiles;
class SettingsKeeper;
class RecoveryBar;
class RepeatActions;
class SessionJournal;
class ShotActions;
class StartCard;
class StatusLine;
class TextureChooser;
class TextureLocator;
class ThemeActions;
class TimeActions;
class Viewport;
class ViewportMenu;

/// The window: makes viewport, docks, menus and actions and connects them to the session. Knows nothing of
/// meshes.
class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    /// What the viewport's context has to be; call before the QApplication is made.
    static void setSurfaceFormat();

    /// `session` outlives the window. Settings are read from and saved to the application's QSettings.
    explicit MainWindow(Session& session, QWidget* parent = nullptr);
    ~MainWindow() override;

    [[nodiscard]] Viewport& viewport() { return *m_viewport; }

    /// For the scene that the program opens with: shows the card with the first steps, unless it was
    /// dismissed at an earlier start. The hits there are may be discarded without a question.
    void showFirstSteps();

    /// Offers what a window left behind that did not end in order.
    void offerRecovery();
    /// Opens a session, or meshes as one scene. Nothing for an empty list.
    void openFiles(const QStringList& paths);
    /// Writes the target in focus as it is on the screen, its normals too unless others are asked for. Errors
    /// are exportTarget()'s.
    [[nodiscard]] Status exportTo(const QString& path, std::optional<NormalMode> normals = {});
    /// The same beside what else the window does; the status bar says how it goes, and how it ended.
    void beginExport(const QString& path, std::optional<NormalMode> normals = {});
    [[nodiscard]] Status savePictureTo(const QString& path);
    /// Reloads the scene's only mesh with its centre at the origin and its largest extent `extent` metres,
    /// or, for extent 0, in its file's own coordinates. Hits are lost.
    void placeMesh(double extent);
    /// Saves the settings, asks nothing: before the program ends without the window being closed. What was
    /// not saved can be recovered at the next start.
    void endInOrder();

protected:
    void closeEvent(QCloseEvent* event) override;
    void changeEvent(QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    // Parts
    void makeCentre();
    void makeDocks();
    QDockWidget* makeSceneDock();
    void lookAt(const Bounds& bounds);
    HitHistoryPanel* makeHistoryPanel();
    QDockWidget* makeHitDock(const HitHistoryPanel& history);
    QDockWidget* makeVertexChangesDock();
    void makeUndoDock(QDockWidget& neighbour, bool isLow);
    QDockWidget* addDock(const QString& name, const QString& title, QWidget* panel, Qt::DockWidgetArea area);
    void makeMenus();
    void makeViewMenu();
    void makeShootMenu();
    void makeHelpMenu();
    void makeToolBar();
    void makeStartCard();
    void connectFiles();
    void connectSession();
    void connectReloading();
    void fillSharing(QMenu& menu);
    void connectMessages();
    void connectViewport();

    // What remains of the window itself
    void showDock(const QString& name);
    void showProjectileDialog();
    void showKeys();
    void say(const QString& text);  ///< in the status bar, for a while
    void fail(const Error& error);
    void followScene();
    void showTitle();
    [[nodiscard]] SessionFiles::View view();
    void restoreView(const SessionDocument& document);
    void followFrameRate();
    void restoreWindow();
    void resetLayout();
    void saveSettings(QSettings& settings);

    Session& m_session;
    AppSettings m_settings;
    HitEffects m_hitEffects;
    HitHistoryModel m_hitHistory;
    MeshStatisticsModel m_meshStatistics;
    SceneModel m_scene;
    Viewport* m_viewport = nullptr;
    NoticeBar* m_notice = nullptr;
    StartCard* m_startCard = nullptr;
    SceneFiles* m_files = nullptr;
    SessionFiles* m_sessions = nullptr;
    SettingsKeeper* m_keeper = nullptr;
    StatusLine* m_status = nullptr;
    TextureChooser* m_textureChooser = nullptr;
    TextureLocator* m_textureLocator = nullptr;
    PipelineChooser* m_pipelines = nullptr;
    FullView* m_fullView = nullptr;
    ViewportMenu* m_viewportMenu = nullptr;
    GoToVertex* m_goToVertex = nullptr;
    HitActions* m_hitActions = nullptr;
    ExportActions* m_exports = nullptr;
    DiscardGuard* m_guard = nullptr;
    RecoveryBar* m_recovery = nullptr;
    SessionJournal* m_journal = nullptr;
    FileActions* m_fileActions = nullptr;
    EditActions* m_edit = nullptr;
    DisplayActions* m_display = nullptr;
    ThemeActions* m_themes = nullptr;
    LightActions* m_lights = nullptr;
    TimeActions* m_time = nullptr;
    ShotActions* m_shots = nullptr;
    CameraActions* m_cameraActions = nullptr;
    PictureActions* m_pictures = nullptr;
    ExchangeActions* m_exchange = nullptr;
    InspectActions* m_inspect = nullptr;
    RepeatActions* m_repeat = nullptr;
    HelpActions* m_help = nullptr;
    ChangeActions* m_change = nullptr;
    CutActions* m_cut = nullptr;
    FrameRatePanel* m_frameRate = nullptr;
    MeshStatisticsPanel* m_statisticsPanel = nullptr;
    QTimer m_frameRateTimer;
    QByteArray m_firstLayout;

    QMenu* m_helpMenu = nullptr;
    QMenu* m_docksMenu = nullptr;
    QMenu* m_meshMenu = nullptr;
    QAction* m_frame = nullptr;
    QAction* m_continuous = nullptr;
};

}  // namespace hitscope
