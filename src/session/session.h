// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/result.h"
#include "deform/hit_history.h"
#include "physics/physics_world.h"
#include "pipeline/capacity_report.h"
#include "pipeline/exactness.h"
#include "pipeline/pipeline_kind.h"
#include "render/camera.h"
#include "render/lights.h"
#include "session/history_undo.h"
#include "session/hit_rows.h"
#include "session/scene_presets.h"
#include "session/target.h"

namespace hitscope {

/// Everything a person works on: targets, hit history, constants, lights, projectiles. Makes no GL call;
/// SceneGpu follows it on the GPU and hands back what the pipeline made. One thread: the one it was created
/// on.
class Session : public QObject {
    Q_OBJECT
public:
    explicit Session(QObject* parent = nullptr);
    ~Session() override;

    // Scene
    void loadPaperRow(int row);  ///< replaces targets and history; 0 <= row < paperRows().size()
    /// Replaces targets and history by one mesh standing on the floor. `mesh` has passed validate().
    void loadMesh(MeshData mesh, const QString& sourcePath = {});
    void loadMesh(const PreparedMesh& mesh, const QString& sourcePath = {});
    void loadTeapot();
    [[nodiscard]] QString sceneName() const;  ///< for the window's title
    [[nodiscard]] std::span<const std::unique_ptr<Target>> targets() const { return m_targets; }
    [[nodiscard]] const Target* target(TargetId id) const;  ///< null: no such target
    [[nodiscard]] Bounds sceneBounds() const;               ///< world, original shapes
    [[nodiscard]] float floorHeight() const { return m_floorHeight; }
    [[nodiscard]] TargetId selectedTarget() const { return m_selectedTarget; }
    void selectTarget(TargetId id);

    // Hits
    [[nodiscard]] const HitHistory& history() const { return m_history; }
    /// Appends a hit made elsewhere (a file, a script); refused as checkedHit() says, or if there is no such
    /// target.
    [[nodiscard]] Status addHit(const Hit& hit);
    /// Undo and redo cover every change of the history: hits made, removed, moved, disabled, cleared, their
    /// constants changed.
    [[nodiscard]] bool canUndo() const { return m_undo.canUndo(); }
    [[nodiscard]] bool canRedo() const { return m_undo.canRedo(); }
    /// What undoHit() and redoHit() would be about; nothing when they would do nothing.
    [[nodiscard]] std::optional<HistoryUndo::Name> undoName() const { return nameOf(m_undo.toUndo()); }
    [[nodiscard]] std::optional<HistoryUndo::Name> redoName() const { return nameOf(m_undo.toRedo()); }
    void undoHit();
    void redoHit();
    /// Each of these is one step to undo, however many hits; indices out of range are passed over.
    void setHitsEnabled(std::span<const std::size_t> indices, bool enabled);
    void enableAllHits();
    /// The hits come to stand together, in their order, before the hit that is now at `to` (<= size()).
    void moveHits(std::span<const std::size_t> indices, std::size_t to);
    void removeHits(std::span<const std::size_t> indices);
    void removeHit(std::size_t index);
    void clearHits();
    [[nodiscard]] std::size_t disabledHits() const { return m_disabledHits; }
    [[nodiscard]] std::optional<std::size_t> selectedHit() const { return m_selectedHit; }
    void selectHit(std::optional<std::size_t> index);

    // Settings
    [[nodiscard]] const DeformationConstants& constants() const { return m_constants; }
    /// Constants of the hits to come and, if `past`, of all made so far. Refused when out of range.
    [[nodiscard]] Status setConstants(const DeformationConstants& constants, bool past);
    [[nodiscard]] const Lights& lights() const { return m_lights; }
    void setLights(const Lights& lights);
    [[nodiscard]] const ProjectileSettings& projectileSettings() const { return m_projectileSettings; }
    void setProjectileSettings(const ProjectileSettings& settings);
    [[nodiscard]] PipelineKind pipeline() const { return m_pipeline; }
    void setPipeline(PipelineKind kind);
    /// Why the driver cannot run a pipeline, in words for the interface; empty: it can, as far as is known.
    [[nodiscard]] QString whyUnavailable(PipelineKind kind) const;

    // Time
    void shoot(const Ray& ray);  ///< world
    /// Steps the physics; contacts become hits.
    void advance(double seconds);
    [[nodiscard]] bool isMoving() const;  ///< projectiles are alive
    [[nodiscard]] const PhysicsWorld& physics() const { return m_physics; }

    // What SceneGpu reports back
    void setExactness(const Exactness& exactness);
    /// Of the renderer that draws; nothing before there is one.
    [[nodiscard]] const std::optional<Exactness>& exactness() const { return m_exactness; }
    /// The pipeline starts over: every target's CPU copy goes back to its original until it is read back.
    void restartReadBack();
    /// What the active pipeline made of a target: vertices [first, first + vertices.size()).
    void takeReadBack(TargetId target, std::uint32_t first, std::span<const DynamicVertex> vertices);
    struct ChangedNormals {
        TargetId target;
        std::vector<std::uint32_t> renderVertices;  ///< sorted, each once
    };
    /// The read-back is complete: recomputes true normals around what moved and emits meshChanged() for each
    /// target concerned. Returns the render vertices whose shading normal changed.
    std::vector<ChangedNormals> finishReadBack();
    void setCapacity(CapacityReport report);
    [[nodiscard]] const CapacityReport& capacity() const { return m_capacity; }
    /// Hits that the active pipeline no longer applies because its capacity was reached.
    [[nodiscard]] std::size_t droppedHits() const { return m_capacity.dropped.size(); }
    [[nodiscard]] bool isDropped(std::size_t index) const;
    void setUnavailablePipelines(std::map<PipelineKind, QString> reasons);

Q_SIGNALS:
    void sceneReplaced();  ///< all targets are new, the history is empty
    void hitsAboutToBeAppended(int first, int last);
    void hitsAppended();
    /// Hits [first, last] are where they were; they were enabled or disabled, or got other constants.
    void hitsChanged(int first, int last);
    void hitsRearranged(const hitscope::HitRows& rows);  ///< removed, put back, moved
    void historyReset();                                 ///< after either of these, and with a new scene
    void meshChanged(hitscope::TargetId target);         ///< its DeformedMesh did
    void constantsChanged();
    void lightsChanged();
    void projectileSettingsChanged();
    void pipelineChanged();
    void exactnessChanged();
    void targetSelected(hitscope::TargetId target);
    void hitSelected();
    void capacityChanged();
    void unavailablePipelinesChanged();
    void pictureChanged();  ///< anything that a new frame would show

private:
    void clearScene();
    void announceScene(const QString& name);
    Target& addTarget(const TargetPlan& plan);
    void appendHits(std::span<const Hit> hits);
    void recordUndo(std::vector<HistoryEdit> edits, HistoryUndo::Name name);
    void changeHistory(std::vector<HistoryEdit> edits, HistoryUndo::Name name);
    void announceEdits(std::span<const HistoryEdit> edits);
    void announceRows(const HitRows& rows);
    static std::optional<HistoryUndo::Name> nameOf(const HistoryUndo::Change* change) {
        return change != nullptr ? std::optional(change->name) : std::nullopt;
    }
    void takeConstants(const DeformationConstants& constants);

    QString m_sceneName;
    std::vector<std::unique_ptr<Target>> m_targets;
    std::uint32_t m_nextTarget = 1;
    float m_floorHeight = 0.0f;
    TargetId m_selectedTarget;
    HitHistory m_history;
    HistoryUndo m_undo;
    std::optional<std::size_t> m_selectedHit;
    DeformationConstants m_constants;
    Lights m_lights;
    ProjectileSettings m_projectileSettings;
    PipelineKind m_pipeline = PipelineKind::TransformFeedback;
    std::optional<Exactness> m_exactness;
    PhysicsWorld m_physics;
    std::size_t m_disabledHits = 0;
    CapacityReport m_capacity;
    std::map<PipelineKind, QString> m_unavailablePipelines;
    std::map<TargetId, std::vector<std::uint32_t>>
        m_moved;  ///< file vertices, since the last finishReadBack()
};

}  // namespace hitscope
