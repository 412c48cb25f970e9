// SPDX-License-Identifier: GPL-3.0-or-later
// The session's scenes: everything that replaces all targets at once.
#include <algorithm>
#include <utility>

#include "mesh/teapot.h"
#include "session/session.h"

namespace hitscope {

void Session::loadScene(ScenePlan plan) {
    clearScene();
    for (TargetPlan& target : plan.targets) {
        insertTarget(m_targets.size(), newTarget(std::move(target)));
    }
    if (m_targets.size() == 1) {
        m_selectedTarget = m_targets.front()->id;
    }
    const Bounds bounds = sceneBounds();
    m_floorHeight = plan.floorHeight.value_or(bounds.empty() ? 0.0f : bounds.min.y);
    announceScene(plan.name);
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
    // Fine enough that a dent of 0.5 m in radius shows its rim.
    constexpr int kDivisions = 32;
    loadMesh(makeTeapot(kDivisions));
}

QString Session::sceneName() const {
    return m_sceneName;
}

const Target* Session::target(TargetId id) const {
    const std::optional<std::size_t> index = indexOf(id);
    return index ? m_targets[*index].get() : nullptr;
}

Bounds Session::sceneBounds() const {
    Bounds visible;
    Bounds all;
    for (const std::unique_ptr<Target>& target : m_targets) {
        const Bounds bounds = target->worldBounds();
        all.add(bounds);
        if (target->visible) {
            visible.add(bounds);
        }
    }
    return visible.empty() ? all : visible;
}

void Session::selectTarget(TargetId id) {
    if (id != m_selectedTarget && (!id || target(id) != nullptr)) {
        m_selectedTarget = id;
        Q_EMIT targetSelected(id);
        Q_EMIT pictureChanged();
    }
}

void Session::clearScene() {
    for (const std::unique_ptr<Target>& target : m_targets) {
        m_physics.removeTarget(target->id);
    }
    m_physics.removeProjectiles();
    cancelScheduled();
    m_tally.clear();
    m_colliders.clear();
    m_stepIsBegun = false;
    m_targets.clear();
    m_readBack->forgetAll();
    m_notHittable.clear();
    m_history.clear();
    m_undo.clear();
    m_selectedHit.reset();
    m_shownHits.reset();
    m_selectedTarget = {};
    m_disabledHits = 0;
}

void Session::announceScene(const QString& name) {
    m_sceneName = name;
    m_physics.setFloor(m_floorHeight);
    // The lights stand around the new scene as they stood around the one before.
    const Bounds bounds = sceneBounds();
    const glm::vec3 size = bounds.size();
    const LightSpace space{bounds.centre(), std::max({size.x, size.y, size.z})};
    m_lights = moved(m_lights, m_lightSpace, space);
    m_lightSpace = space;
    Q_EMIT sceneReplaced();
    Q_EMIT historyReset();
    Q_EMIT shownHitsChanged();
    Q_EMIT undoChanged();
    m_readBack->setCapacity({m_readBack->capacity().capacity, m_readBack->capacity().perTarget, 0, {}});
    Q_EMIT lightsChanged();
    Q_EMIT targetSelected(m_selectedTarget);
    Q_EMIT pictureChanged();
}

}  // namespace hitscope
