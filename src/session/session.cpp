// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/teapot.h"

namespace hitscope {

namespace {

/// Any mesh collides with its own triangles, at its original shape.
MeshCollider meshCollider(const RenderMesh& mesh) {
    MeshCollider collider;
    collider.vertices.reserve(mesh.vertices.size());
    for (const DynamicVertex& vertex : mesh.vertices) {
        collider.vertices.push_back(vertex.position);
    }
    collider.triangles = mesh.triangles;
    return collider;
}

}  // namespace

Session::Session(QObject* parent) : QObject(parent) {}

Session::~Session() = default;

// Scene

void Session::loadPaperRow(int row) {
    const PaperRow& preset = paperRows()[static_cast<std::size_t>(row)];
    std::vector<TargetPlan> plans = planPaperRow(preset);
    clearScene();
    for (const TargetPlan& plan : plans) {
        addTarget(plan);
    }
    m_floorHeight = 0.0f;
    announceScene(preset.label());
}

void Session::loadMesh(MeshData mesh, const QString& sourcePath) {
    loadMesh(prepareMesh(std::move(mesh)), sourcePath);
}

void Session::loadMesh(const PreparedMesh& mesh, const QString& sourcePath) {
    clearScene();
    const QString name = QString::fromStdString(mesh.mesh->name);
    Target& target = addTarget({name, mesh, RigidTransform{}, meshCollider(*mesh.render)});
    target.sourcePath = sourcePath;
    m_selectedTarget = target.id;
    m_floorHeight = mesh.render->bounds.empty() ? 0.0f : mesh.render->bounds.min.y;
    announceScene(name);
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
    const auto found = std::find_if(m_targets.begin(), m_targets.end(),
                                    [id](const std::unique_ptr<Target>& target) { return target->id == id; });
    return found == m_targets.end() ? nullptr : found->get();
}

Bounds Session::sceneBounds() const {
    Bounds bounds;
    for (const std::unique_ptr<Target>& target : m_targets) {
        bounds.add(target->worldBounds());
    }
    return bounds;
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
    m_targets.clear();
    m_moved.clear();
    m_history.clear();
    m_undo.clear();
    m_selectedHit.reset();
    m_selectedTarget = {};
    m_disabledHits = 0;
}

Target& Session::addTarget(const TargetPlan& plan) {
    const TargetId id{m_nextTarget++};
    m_targets.push_back(std::make_unique<Target>(id, plan.name, plan.transform, plan.shape));
    m_physics.addTarget(id, plan.transform, plan.collider);
    return *m_targets.back();
}

void Session::announceScene(const QString& name) {
    m_sceneName = name;
    m_physics.setFloor(m_floorHeight);
    // The lights stand around the scene; which of them are on, and their colours, stay as they were set.
    const Bounds bounds = sceneBounds();
    const glm::vec3 size = bounds.size();
    const Lights placed = defaultLights(bounds.centre(), std::max({size.x, size.y, size.z}));
    for (std::size_t i = 0; i < m_lights.points.size(); ++i) {
        PointLight& light = m_lights.points[i];
        const PointLight& place = placed.points[i];
        light.position = place.position;
        light.constant = place.constant;
        light.linear = place.linear;
        light.quadratic = place.quadratic;
    }
    m_lights.spot.constant = placed.spot.constant;
    m_lights.spot.linear = placed.spot.linear;
    m_lights.spot.quadratic = placed.spot.quadratic;
    Q_EMIT sceneReplaced();
    Q_EMIT historyReset();
    setCapacity({m_capacity.capacity, m_capacity.perTarget, 0, {}});
    Q_EMIT lightsChanged();
    Q_EMIT targetSelected(m_selectedTarget);
    Q_EMIT pictureChanged();
}

// Settings

Status Session::setConstants(const DeformationConstants& constants, bool past) {
    if (!isValid(constants)) {
        return Error{"A deformation constant is out of its range.", "",
                     "Keep to the ranges the panel shows."};
    }
    std::vector<HistoryEdit> edits;
    if (past) {
        edits.push_back(m_history.setConstantsOfAll(constants));
        // Dragging a slider is one change, not hundreds.
        m_undo.record({edits,
                       m_constants,
                       constants,
                       HistoryUndo::Merge::WithSameKind,
                       {HistoryUndo::Kind::Constants, m_history.size()}});
    }
    takeConstants(constants);
    announceEdits(edits);
    return Done{};
}

void Session::takeConstants(const DeformationConstants& constants) {
    if (constants != m_constants) {
        m_constants = constants;
        Q_EMIT constantsChanged();
    }
}

void Session::setLights(const Lights& lights) {
    m_lights = lights;
    Q_EMIT lightsChanged();
    Q_EMIT pictureChanged();
}

void Session::setProjectileSettings(const ProjectileSettings& settings) {
    m_projectileSettings = settings;
    Q_EMIT projectileSettingsChanged();
}

void Session::setPipeline(PipelineKind kind) {
    if (kind != m_pipeline) {
        m_pipeline = kind;
        Q_EMIT pipelineChanged();
        Q_EMIT pictureChanged();
    }
}

void Session::setUnavailablePipelines(std::map<PipelineKind, QString> reasons) {
    if (reasons != m_unavailablePipelines) {
        m_unavailablePipelines = std::move(reasons);
        Q_EMIT unavailablePipelinesChanged();
    }
}

QString Session::whyUnavailable(PipelineKind kind) const {
    const auto reason = m_unavailablePipelines.find(kind);
    return reason == m_unavailablePipelines.end() ? QString() : reason->second;
}

// Time

void Session::shoot(const Ray& ray) {
    m_physics.shoot(ray.origin, ray.direction, m_projectileSettings);
    Q_EMIT pictureChanged();
}

void Session::advance(double seconds) {
    const bool wasMoving = isMoving();
    std::vector<Hit> hits;
    for (const Impact& impact : m_physics.advance(seconds)) {
        const Target* struck = target(impact.target);
        if (struck == nullptr) {
            continue;
        }
        Hit hit;
        hit.target = impact.target;
        hit.point = struck->transform.toLocal(impact.point);
        hit.direction = struck->transform.directionToLocal(impact.direction);
        hit.constants = m_constants;
        hit.time = impact.time;
        hit.speed = impact.speed;
        hit.impulse = impact.impulse;
        if (Result<Hit> checked = checkedHit(hit)) {
            hits.push_back(checked.value());
        }
    }
    appendHits(hits);
    if (wasMoving) {
        Q_EMIT pictureChanged();
    }
}

bool Session::isMoving() const {
    return m_physics.projectileCount() > 0;
}

}  // namespace hitscope
