// SPDX-License-Identifier: GPL-3.0-or-later
// The window's docks: which there are, and where they stand at first.
#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QScreen>
#include <QScrollArea>
#include <algorithm>

#include "analysis/hit_effects.h"
#include "app/actions/camera_actions.h"
#include "app/actions/change_actions.h"
#include "app/actions/cut_actions.h"
#include "app/actions/export_actions.h"
#include "app/actions/file_actions.h"
#include "app/actions/hit_actions.h"
#include "app/main_window.h"
#include "app/scene_files.h"
#include "panels/change/change_panel.h"
#include "panels/cutting_plane/cutting_plane_panel.h"
#include "panels/deformation_constants/deformation_constants_panel.h"
#include "panels/dent_measurement/dent_measurement_panel.h"
#include "panels/frame_rate/cost_view.h"
#include "panels/frame_rate/frame_rate_panel.h"
#include "panels/hit_history/hit_history_panel.h"
#include "panels/hit_inspector/hit_inspector_panel.h"
#include "panels/lights/lights_panel.h"
#include "panels/mesh_statistics/mesh_statistics_panel.h"
#include "panels/pipeline_agreement/pipeline_agreement_panel.h"
#include "panels/scene/scene_panel.h"
#include "panels/undo_history/undo_history_panel.h"
#include "panels/vertex_changes/vertex_changes_panel.h"
#include "scene/measure_costs.h"
#include "viewport/hit_handles.h"
#include "viewport/inspect_tool.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr int kLowScreen = 800;  // pixels

}  // namespace

QDockWidget* MainWindow::addDock(const QString& name, const QString& title, QWidget* panel,
                                 Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    // On a small screen a panel scrolls; the window never grows past the screen for its sake.
    auto* scroll = new QScrollArea(dock);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setWidget(panel);
    dock->setWidget(scroll);
    addDockWidget(area, dock);
    m_docksMenu->addAction(dock->toggleViewAction());
    return dock;
}

void MainWindow::makeDocks() {
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
    m_frameRate = new FrameRatePanel(m_session, *m_continuous, costMeter());
    m_frameRate->costs().setCamera([this] { return m_viewport->camera(); });
    m_meshStatistics.measuring().setStretchLimit(static_cast<float>(m_settings.stretchLimit));
    m_statisticsPanel = new MeshStatisticsPanel(m_session, m_meshStatistics);
    connect(m_statisticsPanel, &MeshStatisticsPanel::lookWanted, this, &MainWindow::lookAt);
    auto* agreementPanel =
        new PipelineAgreementPanel(m_session, [this] { return m_viewport->syncNow().ok(); });
    connect(agreementPanel, &PipelineAgreementPanel::lookWanted, this, &MainWindow::lookAt);
    QDockWidget* statistics = addDock(QStringLiteral("meshStatistics"), tr("Mesh statistics"),
                                      m_statisticsPanel, Qt::RightDockWidgetArea);
    QDockWidget* scene = makeSceneDock();
    HitHistoryPanel* historyPanel = makeHistoryPanel();
    QDockWidget* history =
        addDock(QStringLiteral("hitHistory"), tr("Hit history"), historyPanel, Qt::BottomDockWidgetArea);
    QDockWidget* vertices = makeVertexChangesDock();
    QDockWidget* constants =
        addDock(QStringLiteral("deformationConstants"), tr("Deformation constants"),
                new DeformationConstantsPanel(m_session, m_hitActions->editing()), Qt::RightDockWidgetArea);
    QDockWidget* hit = makeHitDock(*historyPanel);
    QDockWidget* lights =
        addDock(QStringLiteral("lights"), tr("Lights"), new LightsPanel(m_session), Qt::RightDockWidgetArea);
    QDockWidget* frameRate =
        addDock(QStringLiteral("frameRate"), tr("Frame rate"), m_frameRate, Qt::BottomDockWidgetArea);
    QDockWidget* change =
        addDock(QStringLiteral("change"), tr("Change"), m_change->panel(), Qt::RightDockWidgetArea);
    QDockWidget* dent = addDock(QStringLiteral("dentMeasurement"), tr("Dent measurement"),
                                new DentMeasurementPanel(m_session), Qt::RightDockWidgetArea);
    QDockWidget* cut = addDock(QStringLiteral("cuttingPlane"), tr("Cutting plane"), m_cut->panel(),
                               Qt::BottomDockWidgetArea);
    connect(m_cut, &CutActions::switchedOn, cut, &QDockWidget::raise);
    QDockWidget* agreement = addDock(QStringLiteral("pipelineAgreement"), tr("Pipeline agreement"),
                                     agreementPanel, Qt::BottomDockWidgetArea);
    tabifyDockWidget(frameRate, agreement);
    frameRate->raise();
    tabifyDockWidget(statistics, scene);
    tabifyDockWidget(scene, change);
    tabifyDockWidget(history, vertices);
    tabifyDockWidget(vertices, dent);
    tabifyDockWidget(dent, cut);
    history->raise();
    const bool isLow = screen()->availableSize().height() < kLowScreen;
    if (isLow) {
        // Two below one another would both have too little room; so many names are read along the side.
        tabifyDockWidget(change, constants);
        setTabPosition(Qt::RightDockWidgetArea, QTabWidget::East);
    }
    tabifyDockWidget(constants, hit);
    tabifyDockWidget(hit, lights);
    makeUndoDock(*lights, isLow);
    constants->raise();
    statistics->raise();
    const int width = std::max(isLow ? 408 : 378, m_statisticsPanel->minimumSizeHint().width());
    resizeDocks({statistics, constants}, {width, width}, Qt::Horizontal);
    if (!isLow) {
        resizeDocks({statistics, constants}, {360, 230}, Qt::Vertical);
    }
    resizeDocks({history, frameRate}, {235, 235}, Qt::Vertical);
    resizeDocks({history, frameRate}, {620, 380}, Qt::Horizontal);
}

void MainWindow::lookAt(const Bounds& bounds) {
    m_viewport->navigation().frame(bounds);
    m_viewport->update();
}

HitHistoryPanel* MainWindow::makeHistoryPanel() {
    auto* panel = new HitHistoryPanel(m_session, m_hitHistory);
    m_hitActions->adopt(*panel);
    connect(panel, &HitHistoryPanel::flyWanted, this,
            [this](const Bounds& part) { m_viewport->navigation().frame(part); });
    return panel;
}

/// Behind `neighbour`; where there is no room for one more tab, in a window of its own that opens on demand.
void MainWindow::makeUndoDock(QDockWidget& neighbour, bool isLow) {
    QDockWidget* dock = addDock(QStringLiteral("undoHistory"), tr("Undo history"),
                                new UndoHistoryPanel(m_session), Qt::RightDockWidgetArea);
    if (isLow) {
        dock->setFloating(true);
        dock->hide();
    } else {
        tabifyDockWidget(&neighbour, dock);
    }
}

QDockWidget* MainWindow::makeHitDock(const HitHistoryPanel& history) {
    auto* panel = new HitInspectorPanel(m_session, m_hitActions->editing());
    QDockWidget* dock = addDock(QStringLiteral("hit"), tr("Hit"), panel, Qt::RightDockWidgetArea);
    connect(&history, &HitHistoryPanel::editWanted, panel, [dock, panel] {
        dock->show();
        dock->raise();
        panel->editFirst();
    });
    return dock;
}

QDockWidget* MainWindow::makeSceneDock() {
    m_scene.setWriteTarget(
        [this](TargetId target, const QString& path) { return m_exports->writeTarget(target, path); });
    auto* panel = new ScenePanel(m_session, m_scene);
    connect(panel, &ScenePanel::filesWanted, this, [this] { m_fileActions->chooseAddition(); });
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

QDockWidget* MainWindow::makeVertexChangesDock() {
    auto* changes = new VertexChangesModel(m_session, m_hitEffects, this);
    auto* attribution = new AttributionModel(m_session, this);
    auto* panel = new VertexChangesPanel(m_session, *changes, *attribution);
    connect(panel, &VertexChangesPanel::failed, this, &MainWindow::fail);
    connect(panel, &VertexChangesPanel::vertexWanted, m_viewport, &Viewport::lookAt);
    return addDock(QStringLiteral("vertexChanges"), tr("Vertex changes"), panel, Qt::BottomDockWidgetArea);
}

void MainWindow::showDock(const QString& name) {
    if (auto* dock = findChild<QDockWidget*>(name)) {
        dock->show();
        dock->raise();
    }
}

}  // namespace hitscope
