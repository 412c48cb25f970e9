// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>
#include <QTimer>
#include <functional>
#include <optional>

#include "analysis/hit_effects.h"
#include "app/settings/app_settings.h"
#include "models/hit_history_model.h"
#include "models/mesh_statistics_model.h"
#include "models/scene_model.h"
#include "session/sample_scenes.h"
#include "session/session.h"

class QActionGroup;
class QDockWidget;
class QSettings;
class QMenu;

namespace hitscope {

class CameraActions;
class ChangeActions;
class CutActions;
class DiscardGuard;
class FrameRatePanel;
class FullView;
class GoToVertex;
class HelpActions;
class HitActions;
class HitHistoryPanel;
class InspectActions;
class MeshExporter;
class NoticeBar;
class PictureActions;
class MeshStatisticsPanel;
class PipelineChooser;
class SceneFiles;
class SettingsKeeper;
class ShotActions;
class StartCard;
class StatusLine;
class TextureChooser;
class TextureLocator;
class ShadingActions;
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

    /// Opens them all as one scene. Nothing for an empty list.
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
    /// Saves the settings, asks nothing: before the program ends without the window being closed.
    void endInOrder();

protected:
    void closeEvent(QCloseEvent* event) override;
    void changeEvent(QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    static constexpr int kMessageStays = 8000;  // milliseconds in the status bar

    // Parts
    void makeCentre();
    void makeStartCard();
    void makeDocks();
    QDockWidget* makeSceneDock();
    QDockWidget* makeHitDock(const HitHistoryPanel& history);
    QDockWidget* makeVertexChangesDock();
    QDockWidget* addDock(const QString& name, const QString& title, QWidget* panel, Qt::DockWidgetArea area);
    void makeMenus();
    void makeFileMenu();
    void makeEditMenu();
    void makeViewMenu();
    void makeDisplayActions(QMenu& menu);
    void makeThemeMenus(QMenu& menu);
    void makeMeshMenu();
    void makeShootMenu();
    void makeLightsMenu();
    void makeHelpMenu();
    void makeToolBar();
    QMenu* makeWireframeMenu();
    void connectFiles();
    void connectCameraAndPictures();
    void connectPicking();
    void showDock(const QString& name);
    void restoreWindow();
    void resetLayout();

    // Actions
    QAction* addAction(QMenu& menu, const QString& text, const QKeySequence& keys, std::function<void()> act,
                       const QString& icon = {});
    QAction* addToggle(QMenu& menu, const QString& text, const QKeySequence& keys, bool on,
                       std::function<void(bool)> act);
    /// A checkable action in a group of which one is on.
    QAction* addChoice(QMenu& menu, QActionGroup& group, const QString& text, bool on,
                       std::function<void()> act);
    /// An action whose key the viewport handles itself, since it is held down; the menu shows it.
    QAction* addHeldKey(QMenu& menu, const QString& text, const QString& key, std::function<void()> act);

    // Doing
    void chooseFile();
    void askAndOpen(const QStringList& paths);
    void chooseAddition();
    QStringList chooseMeshes(const QString& title);
    void loadSample(SampleScene scene);
    void chooseExport();
    QStringList chooseExports(const std::vector<TargetId>& targets);
    QString chooseExportOf(const Target& target);
    QStringList exportAllInto(const std::vector<TargetId>& targets);
    bool beginExportOf(const Target& target, const QString& path, NormalMode normals);
    void sayNotYet(const QString& text);
    void choosePlacement();
    void showRecentFiles();
    void saidOpened(const QStringList& paths, const QStringList& notes);
    void cycleWireframe();
    void changeDisplay(const std::function<void(DisplayOptions&)>& change);
    void toggleLight(const std::function<void(Lights&)>& change);
    void chooseTheme(ThemeChoice choice);
    void showProjectileDialog();
    void showKeys();

    // Showing
    void followScene();
    void followTargets();
    void followHistory();
    void followDisplay();
    void followLights();
    void followViewportTheme();
    void followFrameRate();
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
    MeshExporter* m_exporter = nullptr;
    DiscardGuard* m_guard = nullptr;
    SettingsKeeper* m_keeper = nullptr;
    HitActions* m_hitActions = nullptr;
    StatusLine* m_status = nullptr;
    TextureChooser* m_textureChooser = nullptr;
    TextureLocator* m_textureLocator = nullptr;
    TimeActions* m_time = nullptr;
    ShadingActions* m_shading = nullptr;
    ShotActions* m_shots = nullptr;
    PipelineChooser* m_pipelines = nullptr;
    CameraActions* m_cameraActions = nullptr;
    PictureActions* m_pictures = nullptr;
    FullView* m_fullView = nullptr;
    InspectActions* m_inspect = nullptr;
    GoToVertex* m_goToVertex = nullptr;
    HelpActions* m_help = nullptr;
    ViewportMenu* m_viewportMenu = nullptr;
    ChangeActions* m_change = nullptr;
    CutActions* m_cut = nullptr;
    FrameRatePanel* m_frameRate = nullptr;
    MeshStatisticsPanel* m_statisticsPanel = nullptr;
    QTimer m_frameRateTimer;
    QByteArray m_firstLayout;

    QMenu* m_recentMenu = nullptr;
    QMenu* m_scenesMenu = nullptr;
    QMenu* m_helpMenu = nullptr;
    QMenu* m_docksMenu = nullptr;
    QMenu* m_meshMenu = nullptr;
    QMenu* m_wireframeMenu = nullptr;
    QAction* m_open = nullptr;
    QAction* m_export = nullptr;
    QAction* m_undo = nullptr;
    QAction* m_redo = nullptr;
    QAction* m_enableAll = nullptr;
    QAction* m_clear = nullptr;
    QAction* m_frame = nullptr;
    QAction* m_continuous = nullptr;
    QAction* m_placeMesh = nullptr;
    QAction* m_fileCoordinates = nullptr;
    QAction* m_bounces = nullptr;
    QAction* m_wireframes[3] = {};  ///< by WireframeMode
    QAction* m_normals[2] = {};     ///< by NormalMode
    QAction* m_textures = nullptr;
    QAction* m_floor = nullptr;
    QAction* m_crosshair = nullptr;
    QAction* m_lights[3] = {};  ///< directional, points, spot
};

}  // namespace hitscope
