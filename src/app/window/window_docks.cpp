// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/window_docks.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QScreen>
#include <QScrollArea>
#include <QSettings>
#include <algorithm>

#include "analysis/hit_effects.h"
#include "app/actions/change_actions.h"
#include "app/actions/cut_actions.h"
#include "app/actions/display_actions.h"
#include "app/actions/export_actions.h"
#include "app/actions/file_actions.h"
#include "app/actions/hit_actions.h"
#include "app/full_view.h"
#include "app/scene_files.h"
#include "app/settings/app_settings.h"
#include "app/window/window_actions.h"
#include "app/window/window_menus.h"
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
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr int kLowScreen = 800;    // pixels
constexpr int kLayoutVersion = 6;  // docks that are gone or new make an old layout useless

const QString kGeometryKey = QStringLiteral("window/geometry");
const QString kLayoutKey = QStringLiteral("window/layout");
const QString kFrameRateKey = QStringLiteral("window/frameRate");
const QString kStatisticsKey = QStringLiteral("window/meshStatistics");

}  // namespace

struct WindowDocks::Docks {
    QDockWidget* statistics = nullptr;
    QDockWidget* scene = nullptr;
    QDockWidget* history = nullptr;
    QDockWidget* vertices = nullptr;
    QDockWidget* constants = nullptr;
    QDockWidget* hit = nullptr;
    QDockWidget* lights = nullptr;
    QDockWidget* frameRate = nullptr;
    QDockWidget* change = nullptr;
    QDockWidget* dent = nullptr;
    QDockWidget* cut = nullptr;
    QDockWidget* agreement = nullptr;
    QDockWidget* undo = nullptr;
};

WindowDocks::WindowDocks(const Parts& parts)
    : QObject(&parts.window),
      m_parts(parts),
      m_hitHistory(parts.session, &parts.effects),
      m_meshStatistics(parts.session),
      m_scene(parts.session),
      m_isLow(parts.window.screen()->availableSize().height() < kLowScreen) {
    m_parts.window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    m_parts.window.setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
    Docks docks;
    make(docks);
    arrange(docks);
}

WindowDocks::~WindowDocks() {
    qDeleteAll(m_docks);  // before the models that they show, which are members
}

QDockWidget* WindowDocks::add(const QString& name, const QString& title, QWidget* panel,
                              Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(title, &m_parts.window);
    dock->setObjectName(name);
    // On a small screen a panel scrolls; the window never grows past the screen for its sake.
    auto* scroll = new QScrollArea(dock);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setWidget(panel);
    dock->setWidget(scroll);
    m_parts.window.addDockWidget(area, dock);
    m_parts.menus.docks().addAction(dock->toggleViewAction());
    m_docks.push_back(dock);
    return dock;
}

void WindowDocks::make(Docks& docks) {
    Session& session = m_parts.session;
    docks.statistics = makeStatisticsDock();
    docks.scene = makeSceneDock();
    docks.history = makeHistoryDock();
    docks.vertices = makeVertexChangesDock();
    auto* constants = new DeformationConstantsPanel(session, m_parts.actions.hits->editing());
    docks.constants = add(QStringLiteral("deformationConstants"), tr("Deformation constants"), constants,
                          Qt::RightDockWidgetArea);
    docks.hit = makeHitDock(*constants);
    docks.lights =
        add(QStringLiteral("lights"), tr("Lights"), new LightsPanel(session), Qt::RightDockWidgetArea);
    docks.frameRate = makeFrameRateDock();
    docks.change =
        add(QStringLiteral("change"), tr("Change"), m_parts.actions.change->panel(), Qt::RightDockWidgetArea);
    docks.dent = add(QStringLiteral("dentMeasurement"), tr("Dent measurement"),
                     new DentMeasurementPanel(session), Qt::RightDockWidgetArea);
    docks.cut = add(QStringLiteral("cuttingPlane"), tr("Cutting plane"), m_parts.actions.cut->panel(),
                    Qt::BottomDockWidgetArea);
    connect(m_parts.actions.cut, &CutActions::switchedOn, docks.cut, &QDockWidget::raise);
    docks.agreement = makeAgreementDock();
    docks.undo = add(QStringLiteral("undoHistory"), tr("Undo history"), new UndoHistoryPanel(session),
                     Qt::RightDockWidgetArea);
}

/// Which docks share a place, in which order, and how large they are.
void WindowDocks::arrange(const Docks& docks) {
    QMainWindow& window = m_parts.window;
    window.tabifyDockWidget(docks.frameRate, docks.agreement);
    docks.frameRate->raise();
    window.tabifyDockWidget(docks.statistics, docks.scene);
    window.tabifyDockWidget(docks.scene, docks.change);
    window.tabifyDockWidget(docks.history, docks.vertices);
    window.tabifyDockWidget(docks.vertices, docks.dent);
    window.tabifyDockWidget(docks.dent, docks.cut);
    docks.history->raise();
    if (m_isLow) {
        // So many names are read along the side.
        window.tabifyDockWidget(docks.change, docks.constants);
        window.setTabPosition(Qt::RightDockWidgetArea, QTabWidget::East);
    }
    window.tabifyDockWidget(docks.constants, docks.hit);
    window.tabifyDockWidget(docks.hit, docks.lights);
    if (m_isLow) {  // no room for one more tab: a window of its own, which opens on demand
        docks.undo->setFloating(true);
        docks.undo->hide();
    } else {
        window.tabifyDockWidget(docks.lights, docks.undo);
    }
    docks.constants->raise();
    docks.statistics->raise();
    const int width = std::max(m_isLow ? 408 : 378, m_statisticsPanel->minimumSizeHint().width());
    window.resizeDocks({docks.statistics, docks.constants}, {width, width}, Qt::Horizontal);
    if (!m_isLow) {
        window.resizeDocks({docks.statistics, docks.constants}, {360, 230}, Qt::Vertical);
    }
    window.resizeDocks({docks.history, docks.frameRate}, {235, 235}, Qt::Vertical);
    window.resizeDocks({docks.history, docks.frameRate}, {620, 380}, Qt::Horizontal);
}

QDockWidget* WindowDocks::makeStatisticsDock() {
    m_meshStatistics.measuring().setStretchLimit(static_cast<float>(m_parts.settings.stretchLimit));
    m_statisticsPanel = new MeshStatisticsPanel(m_parts.session, m_meshStatistics);
    connect(m_statisticsPanel, &MeshStatisticsPanel::lookWanted, this, &WindowDocks::lookAt);
    return add(QStringLiteral("meshStatistics"), tr("Mesh statistics"), m_statisticsPanel,
               Qt::RightDockWidgetArea);
}

QDockWidget* WindowDocks::makeSceneDock() {
    m_scene.setWriteTarget([this](TargetId target, const QString& path) {
        return m_parts.actions.exports->writeTarget(target, path);
    });
    auto* panel = new ScenePanel(m_parts.session, m_scene);
    connect(panel, &ScenePanel::said, this, &WindowDocks::said);
    connect(panel, &ScenePanel::filesWanted, this, [this] { m_parts.actions.file->chooseAddition(); });
    connect(
        panel, &ScenePanel::targetWanted, this,
        [this](const QString& name, const std::function<TargetPlan()>& make) {
            m_parts.files.make(name, SceneFiles::Into::ThisScene, [make] { return ScenePlan{{}, {make()}}; });
        });
    m_parts.viewport.addActions(panel->targetActions());
    QMenu& menu = m_parts.menus.mesh();
    QAction* first = menu.actions().constFirst();
    menu.insertMenu(first, panel->addMenu());
    menu.insertSeparator(first);
    return add(QStringLiteral("scene"), tr("Scene"), panel, Qt::RightDockWidgetArea);
}

QDockWidget* WindowDocks::makeHistoryDock() {
    m_historyPanel = new HitHistoryPanel(m_parts.session, m_hitHistory);
    m_parts.actions.hits->adopt(*m_historyPanel);
    connect(m_historyPanel, &HitHistoryPanel::flyWanted, this,
            [this](const Bounds& part) { m_parts.viewport.navigation().frame(part); });
    return add(QStringLiteral("hitHistory"), tr("Hit history"), m_historyPanel, Qt::BottomDockWidgetArea);
}

QDockWidget* WindowDocks::makeVertexChangesDock() {
    auto* changes = new VertexChangesModel(m_parts.session, m_parts.effects, this);
    auto* attribution = new AttributionModel(m_parts.session, this);
    auto* panel = new VertexChangesPanel(m_parts.session, *changes, *attribution);
    connect(panel, &VertexChangesPanel::failed, this, &WindowDocks::failed);
    connect(panel, &VertexChangesPanel::vertexWanted, &m_parts.viewport, &Viewport::lookAt);
    return add(QStringLiteral("vertexChanges"), tr("Vertex changes"), panel, Qt::BottomDockWidgetArea);
}

QDockWidget* WindowDocks::makeHitDock(const DeformationConstantsPanel& constants) {
    auto* panel = new HitInspectorPanel(m_parts.session, m_parts.actions.hits->editing());
    QDockWidget* dock = add(QStringLiteral("hit"), tr("Hit"), panel, Qt::RightDockWidgetArea);
    connect(&constants, &DeformationConstantsPanel::presetsChanged, panel, &HitInspectorPanel::followPresets);
    connect(m_historyPanel, &HitHistoryPanel::editWanted, panel, [dock, panel] {
        dock->show();
        dock->raise();
        panel->editFirst();
    });
    return dock;
}

QDockWidget* WindowDocks::makeFrameRateDock() {
    m_frameRate = new FrameRatePanel(m_parts.session, *m_parts.actions.display->continuous(), costMeter());
    m_frameRate->costs().setCamera([this] { return m_parts.viewport.camera(); });
    PictureRefiner& refiner = m_parts.viewport.pictures().refiner();
    m_frameRate->setHeld([&refiner] { return refiner.isUnderWay(); });
    connect(&refiner, &PictureRefiner::aboutToShow, m_frameRate, &FrameRatePanel::refresh);
    return add(QStringLiteral("frameRate"), tr("Frame rate"), m_frameRate, Qt::BottomDockWidgetArea);
}

QDockWidget* WindowDocks::makeAgreementDock() {
    auto* panel =
        new PipelineAgreementPanel(m_parts.session, [this] { return m_parts.viewport.syncNow().ok(); });
    connect(panel, &PipelineAgreementPanel::lookWanted, this, &WindowDocks::lookAt);
    return add(QStringLiteral("pipelineAgreement"), tr("Pipeline agreement"), panel,
               Qt::BottomDockWidgetArea);
}

void WindowDocks::lookAt(const Bounds& bounds) {
    m_parts.viewport.navigation().frame(bounds);
    m_parts.viewport.wantPicture();
}

void WindowDocks::show(const QString& name) {
    if (auto* dock = m_parts.window.findChild<QDockWidget*>(name)) {
        dock->show();
        dock->raise();
    }
}

/// A layout for a small screen is no good on a large one, and the other way round.
QString WindowDocks::forThisScreen(const QString& key) const {
    return m_isLow ? key + QStringLiteral("OnSmallScreen") : key;
}

void WindowDocks::restore(const QSettings& settings) {
    m_firstLayout = m_parts.window.saveState(kLayoutVersion);
    m_frameRate->restoreState(settings.value(kFrameRateKey).toByteArray());
    m_statisticsPanel->restoreState(settings.value(kStatisticsKey).toByteArray());
    m_parts.window.restoreGeometry(settings.value(forThisScreen(kGeometryKey)).toByteArray());
    m_parts.window.restoreState(settings.value(forThisScreen(kLayoutKey)).toByteArray(), kLayoutVersion);
}

void WindowDocks::save(QSettings& settings) {
    if (!m_parts.actions.fullView->isOn()) {  // what is remembered is the window with all its parts
        settings.setValue(forThisScreen(kGeometryKey), m_parts.window.saveGeometry());
        settings.setValue(forThisScreen(kLayoutKey), m_parts.window.saveState(kLayoutVersion));
    }
    settings.setValue(kFrameRateKey, m_frameRate->saveState());
    settings.setValue(kStatisticsKey, m_statisticsPanel->saveState());
    m_parts.settings.stretchLimit = static_cast<double>(m_meshStatistics.measuring().stretchLimit());
}

void WindowDocks::reset() {
    m_parts.window.restoreState(m_firstLayout, kLayoutVersion);
}

}  // namespace hitscope
