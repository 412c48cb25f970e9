// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session.h"

#include <algorithm>
#include <utility>

#include "session/frame_costs.h"
#include "session/primitive_target.h"
#include "session/task_list.h"
#include "session/vertex_selection.h"

namespace hitscope {

Session::Session(QObject* parent)
    : QObject(parent),
      m_readBack(std::make_unique<ReadBack>(m_targets.m_targets)),
      m_frameCosts(std::make_unique<FrameCosts>(*this)),
      m_selection(std::make_unique<VertexSelection>(*this)),
      m_tasks(std::make_unique<TaskList>()) {}

Session::~Session() = default;

// Scenes

void Session::loadScene(ScenePlan plan, SessionUndo::Kind kind) {
    const bool isFirst = m_targets.empty();
    SceneState before = isFirst ? SceneState{} : scene();
    clearScene();
    m_targets.replace(std::move(plan.targets), plan.floorHeight);
    m_sceneName = plan.name;
    const Bounds bounds = m_targets.bounds();
    const glm::vec3 size = bounds.size();
    m_settings.standAround({bounds.centre(), std::max({size.x, size.y, size.z})});
    if (isFirst) {
        m_undo.clear();
    } else {
        m_undo.record({.name = {kind, 1},
                       .scene = std::make_shared<const ValueEdit<SceneState>>(
                           ValueEdit<SceneState>{std::move(before), scene()})});
    }
    announceScene();
}

void Session::restoreScene(const SceneState& scene) {
    m_undo.clear();
    show(scene);
    Q_EMIT undoChanged();
}

SceneState Session::scene() const {
    SceneState state;
    state.name = m_sceneName;
    state.floorHeight = m_targets.floorHeight();
    state.lightSpace = m_settings.lightSpace();
    state.lights = m_settings.lights();
    state.selected = m_targets.selected();
    const std::span<const Hit> hits = m_hits.history().hits();
    state.hits.assign(hits.begin(), hits.end());
    for (const std::unique_ptr<Target>& target : m_targets) {
        state.targets.push_back(*target);
    }
    return state;
}

void Session::clearScene() {
    m_simulation.clear();
    m_targets.clear();
    m_readBack->forgetAll();
    m_hits.forgetAll();
}

void Session::announceScene() {
    m_simulation.setFloor(m_targets.floorHeight());
    Q_EMIT sceneReplaced();
    Q_EMIT m_hits.reset();
    Q_EMIT m_hits.shownChanged();
    Q_EMIT undoChanged();
    m_readBack->setCapacity({m_readBack->capacity().capacity, m_readBack->capacity().perTarget, 0, {}});
    Q_EMIT m_settings.lightsChanged();
    Q_EMIT m_targets.selectedChanged(m_targets.selected());
    Q_EMIT pictureChanged();
}

/// Who follows the session sees a scene without hits, and then hits that are appended.
void Session::show(const SceneState& scene) {
    clearScene();
    m_sceneName = scene.name;
    m_targets.restore(scene.targets, scene.floorHeight, scene.selected);
    m_settings.stand(scene.lights, scene.lightSpace);
    announceScene();
    m_hits.bringBack(scene.hits);
}

void Session::loadPaperRow(int row) {
    const PaperRow& preset = paperRows()[static_cast<std::size_t>(row)];
    loadScene({preset.label(), planPaperRow(preset), 0.0f});
}

void Session::loadMesh(MeshData mesh, const QString& sourcePath) {
    loadMesh(prepareMesh(std::move(mesh)), sourcePath);
}

void Session::loadMesh(const PreparedMesh& mesh, const QString& sourcePath) {
    ScenePlan plan;
    plan.targets.push_back(planMesh(mesh, sourcePath));
    plan.name = plan.targets.front().name;
    loadScene(std::move(plan));
}

void Session::loadTeapot() {
    ScenePlan plan;
    plan.targets.push_back(planBuiltIn(BuiltInMesh::Teapot));
    plan.name = plan.targets.front().name;
    loadScene(std::move(plan));
}

// Steps to undo

void Session::record(SessionUndo::Change change) {
    m_undo.record(std::move(change));
    Q_EMIT undoChanged();
}

void Session::undo() {
    if (m_undo.canUndo()) {
        makeAgain(m_undo.undo());
    }
}

void Session::redo() {
    if (m_undo.canRedo()) {
        makeAgain(m_undo.redo());
    }
}

void Session::goToStep(std::size_t done) {
    while (m_undo.done() > done && m_undo.canUndo()) {
        undo();
    }
    while (m_undo.done() < done && m_undo.canRedo()) {
        redo();
    }
}

void Session::makeAgain(const SessionUndo::Change& change) {
    if (change.scene) {
        show(change.scene->after);
    }
    m_hits.makeAgain(change.edits);
    if (change.settings) {
        m_settings.take(change.settings->after);
    }
    follow(change);
    Q_EMIT undoChanged();
}

/// A hit is never on a target that is not there: targets come before their hits, and go after them.
void Session::follow(const SessionUndo::Change& change) {
    for (const TargetEdit& edit : change.targets) {
        if (edit.after) {
            m_targets.follow(edit);
        }
    }
    m_hits.announce(change.edits);
    for (const TargetEdit& edit : change.targets) {
        if (!edit.after) {
            m_targets.follow(edit);
        }
    }
    if (!change.targets.empty()) {
        Q_EMIT pictureChanged();
    }
}

void Session::expectMoves(std::span<const HistoryEdit> edits) {
    m_readBack->expectMoves();
    m_simulation.follow(edits);
}

}  // namespace hitscope
