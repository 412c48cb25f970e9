// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QObject>
#include <QString>
#include <vector>

#include "core/bounds.h"
#include "core/result.h"
#include "models/hit_history_model.h"
#include "models/mesh_statistics_model.h"
#include "models/scene_model.h"

class QDockWidget;
class QMainWindow;
class QSettings;

namespace hitscope {

struct AppSettings;
class DeformationConstantsPanel;
class FrameRatePanel;
class HitEffects;
class HitHistoryPanel;
class MeshStatisticsPanel;
class SceneFiles;
class Session;
class Viewport;
struct WindowActions;
class WindowMenus;

/// The window's docks with their panels and models: which there are, where they stand at first, and where
/// they stood the last time.
class WindowDocks : public QObject {
    Q_OBJECT
public:
    /// What the panels work with; all of it outlives this.
    struct Parts {
        Session& session;
        AppSettings& settings;
        HitEffects& effects;
        Viewport& viewport;
        SceneFiles& files;
        const WindowActions& actions;
        WindowMenus& menus;
        QMainWindow& window;
    };
    /// Makes them, and lists them in the menu of docks.
    explicit WindowDocks(const Parts& parts);
    ~WindowDocks() override;

    /// Opens the dock of that object name, before those that share its place.
    void show(const QString& name);
    [[nodiscard]] FrameRatePanel& frameRate() { return *m_frameRate; }

    /// Where the window, its docks and bars are, and how the panels are set. Once the tool bar is there too.
    void restore(const QSettings& settings);
    void save(QSettings& settings);
    /// Back to where they stood at first.
    void reset();

Q_SIGNALS:
    void failed(const hitscope::Error& error);
    void said(const QString& text);

private:
    struct Docks;

    QDockWidget* add(const QString& name, const QString& title, QWidget* panel, Qt::DockWidgetArea area);
    void make(Docks& docks);
    [[nodiscard]] QString forThisScreen(const QString& key) const;
    void arrange(const Docks& docks);
    QDockWidget* makeStatisticsDock();
    QDockWidget* makeSceneDock();
    QDockWidget* makeHistoryDock();
    QDockWidget* makeHitDock(const DeformationConstantsPanel& constants);
    QDockWidget* makeVertexChangesDock();
    QDockWidget* makeFrameRateDock();
    QDockWidget* makeAgreementDock();
    void lookAt(const Bounds& bounds);

    Parts m_parts;
    HitHistoryModel m_hitHistory;
    MeshStatisticsModel m_meshStatistics;
    SceneModel m_scene;
    std::vector<QDockWidget*> m_docks;
    HitHistoryPanel* m_historyPanel = nullptr;
    FrameRatePanel* m_frameRate = nullptr;
    MeshStatisticsPanel* m_statisticsPanel = nullptr;
    bool m_isLow;  ///< the screen: two docks below one another have no room on the right side
    QByteArray m_firstLayout;
};

}  // namespace hitscope
