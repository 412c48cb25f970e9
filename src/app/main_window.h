// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>
#include <optional>

#include "analysis/hit_effects.h"
#include "app/settings/app_settings.h"
#include "app/window/window_actions.h"
#include "app/window/window_view.h"
#include "session/session.h"

class QSettings;

namespace hitscope {

class JournalKeeping;
class MeshReloader;
class RecoveryBar;
class SettingsKeeper;
class StartCard;
class StatusLine;
class WindowDocks;
class WindowMenus;

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

private:
    void makeCentre();
    void makeOverlays();
    void makeStartCard();
    void connectSession();
    void connectSettings();
    void connectMessages();
    void connectViewport();
    template <class Part>
    void listenTo(const Part* part);

    void say(const QString& text);  ///< in the status bar, for a while
    void fail(const Error& error);
    void followScene();
    void showTitle();
    void restoreWindow();
    void saveSettings(QSettings& settings);

    Session& m_session;
    AppSettings m_settings;
    HitEffects m_hitEffects;
    Viewport* m_viewport = nullptr;
    WindowActions m_actions;
    WindowView m_view;
    NoticeBar* m_notice = nullptr;
    SceneFiles* m_files = nullptr;
    SessionFiles* m_sessions = nullptr;
    StatusLine* m_status = nullptr;
    DiscardGuard* m_guard = nullptr;
    RecoveryBar* m_recovery = nullptr;
    MeshReloader* m_reloader = nullptr;
    std::optional<std::size_t> m_reloads;  ///< steps done after the last one, while it is spoken of
    WindowMenus* m_menus = nullptr;
    WindowDocks* m_docks = nullptr;
    JournalKeeping* m_journal = nullptr;
    SettingsKeeper* m_keeper = nullptr;
    StartCard* m_startCard = nullptr;
};

}  // namespace hitscope
