// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

#include "session/frame_costs.h"
#include "session/primitive_target.h"
#include "session/task_list.h"
#include "session/vertex_selection.h"

namespace hitscope {

namespace {

/// Whether `next` takes out the hits that stood just before those that `edit` took out, and no other comes.
bool takesOutBefore(const HistoryEdit& edit, const HistoryEdit& next) {
    return edit.after.empty() && next.after.empty() && next.first + next.before.size() == edit.first;
}

bool putsInBehind(const HistoryEdit& edit, const HistoryEdit& next) {
    return edit.before.empty() && next.before.empty() && next.first == edit.first + edit.after.size();
}

/// The same edits in fewer: hits that were made one by one are taken out, or put in again, in one go.
std::vector<HistoryEdit> joined(const std::vector<HistoryEdit>& edits) {
    std::vector<HistoryEdit> fewer;
    for (auto edit = edits.begin(); edit != edits.end();) {
        auto end = edit + 1;
        if (end != edits.end() && takesOutBefore(*edit, *end)) {
            end = std::adjacent_find(edit, edits.end(), std::not_fn(takesOutBefore));
            end += end == edits.end() ? 0 : 1;
            fewer.push_back({(end - 1)->first, {}, {}});
            std::for_each(std::make_reverse_iterator(end), std::make_reverse_iterator(edit),
                          [&all = fewer.back().before](const HistoryEdit& one) {
                              all.insert(all.end(), one.before.begin(), one.before.end());
                          });
        } else if (end != edits.end() && putsInBehind(*edit, *end)) {
            end = std::adjacent_find(edit, edits.end(), std::not_fn(putsInBehind));
            end += end == edits.end() ? 0 : 1;
            fewer.push_back({edit->first, {}, {}});
            std::for_each(edit, end, [&all = fewer.back().after](const HistoryEdit& one) {
                all.insert(all.end(), one.after.begin(), one.after.end());
            });
        } else {
            fewer.push_back(*edit);
        }
        edit = end;
    }
    return fewer;
}

}  // namespace

Session::Session(QObject* parent)
    : QObject(parent),
      m_readBack(std::make_unique<ReadBack>(m_targets.m_targets)),
      m_frameCosts(std::make_unique<FrameCosts>(*this)),
      m_selection(std::make_unique<VertexSelection>(*this)),
      m_tasks(std::make_unique<TaskList>()) {}

Session::~Session() = default;

// Scenes

void Session::loadScene(ScenePlan plan, SessionUndo::Kind kind) {
    const bool isFirst = m_targets.empty() && m_undo.size() == 0;
    SceneState before = isFirst ? SceneState{} : scene();
    clearScene();
    m_simulation.setTime(0.0);
    m_targets.replace(std::move(plan.targets), plan.floorHeight);
    m_sceneName = plan.name;
    const Bounds bounds = m_targets.bounds();
    const glm::vec3 size = bounds.size();
    m_settings.standAround({bounds.centre(), std::max({size.x, size.y, size.z})});
    if (isFirst) {
        m_undo.clear();
    } else {
        SceneState after = scene();
        after.cut.reset();  // who shows it places it
        m_undo.record({.name = {kind, 1},
                       .scene = std::make_shared<const ValueEdit<SceneState>>(
                           ValueEdit<SceneState>{std::move(before), std::move(after)})});
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
    state.cut = m_settings.cut();
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
    if (scene.cut) {
        m_settings.restoreCut(*scene.cut);
    }
    m_hits.bringBack(scene.hits);
    double latest = m_simulation.physics().clock().time();
    for (const Hit& hit : scene.hits) {
        latest = std::max(latest, hit.time);
    }
    m_simulation.setTime(latest);  // those to come are later
}

// Steps to undo

void Session::record(SessionUndo::Change change) {
    m_undo.record(std::move(change));
    Q_EMIT undoChanged();
}

void Session::undo() {
    if (m_undo.canUndo()) {
        makeAgain(takeBack());
    }
}

void Session::redo() {
    if (m_undo.canRedo()) {
        makeAgain(doAgain());
    }
}

/// Steps that only made or changed hits are announced together: there may be a hundred thousand.
void Session::goToStep(std::size_t done) {
    std::vector<HistoryEdit> edits;
    std::vector<TargetPlace> places;
    const auto announce = [this, &edits, &places] {
        if (!edits.empty()) {
            follow({.edits = joined(std::exchange(edits, {})), .places = std::exchange(places, {})});
        }
    };
    while ((m_undo.done() > done && m_undo.canUndo()) || (m_undo.done() < done && m_undo.canRedo())) {
        const SessionUndo::Change change = m_undo.done() > done ? takeBack() : doAgain();
        if (change.scene || change.settings || !change.targets.empty()) {
            announce();
            makeAgain(change);
        } else {
            m_hits.makeAgain(change.edits);
            edits.insert(edits.end(), change.edits.begin(), change.edits.end());
            places.insert(places.end(), change.places.begin(), change.places.end());
        }
    }
    announce();
    Q_EMIT undoChanged();
}

/// Dynamic targets are then where they were before the step that is taken back.
SessionUndo::Change Session::takeBack() {
    SessionUndo::Change change =
        m_undo.undo(m_hits.history().hits(), [this] { return m_simulation.dynamicPlaces(); });
    m_simulation.putBack(change.places);
    return change;
}

SessionUndo::Change Session::doAgain() {
    SessionUndo::Change change = m_undo.redo([this] { return m_simulation.dynamicPlaces(); });
    m_simulation.putBack(change.places);
    return change;
}

void Session::makeAgain(const SessionUndo::Change& change) {
    if (change.scene) {
        show(change.scene->after);
    }
    m_hits.makeAgain(change.edits);
    follow(change);
    Q_EMIT undoChanged();
}

/// A hit is never on a target that is not there: targets come before their hits, and go after them.
void Session::follow(const SessionUndo::Change& change) {
    if (change.settings) {
        m_settings.take(change.settings->after);
    }
    for (const TargetEdit& edit : change.targets) {
        if (edit.after) {
            m_targets.follow(edit);
        }
    }
    m_hits.announce(change.edits);
    m_simulation.shapeAt(change.places);
    for (const TargetEdit& edit : change.targets) {
        if (!edit.after) {
            m_targets.follow(edit);
        }
    }
    if (change.selection) {
        m_targets.select(change.selection->after.target, change.selection->after.beside);
    }
    if (!change.targets.empty()) {
        Q_EMIT pictureChanged();
    }
    for (const TargetEdit& edit : change.targets) {
        if (change.name.kind == SessionUndo::Kind::ScaleTarget && edit.after) {
            Q_EMIT m_targets.scaled(edit.after->id);
        }
    }
}

void Session::expectMoves(std::span<const HistoryEdit> edits) {
    m_readBack->expectMoves();
    m_simulation.follow(edits);
}

// Scenes to load

void loadPaperRow(Session& session, int row) {
    const PaperRow& preset = paperRows()[static_cast<std::size_t>(row)];
    session.loadScene({preset.label(), planPaperRow(preset), 0.0f});
}

namespace {

void load(Session& session, TargetPlan target) {
    ScenePlan plan;
    plan.name = target.name;
    plan.targets.push_back(std::move(target));
    session.loadScene(std::move(plan));
}

}  // namespace

void loadMesh(Session& session, MeshData mesh, const QString& sourcePath) {
    load(session, planMesh(std::move(mesh), sourcePath));
}

void loadMesh(Session& session, const PreparedMesh& mesh, const QString& sourcePath) {
    load(session, planMesh(mesh, sourcePath));
}

void loadTeapot(Session& session) {
    ScenePlan plan;
    plan.targets.push_back(planBuiltIn(BuiltInMesh::Teapot));
    plan.name = plan.targets.front().name;
    session.loadScene(std::move(plan));
}

}  // namespace hitscope
