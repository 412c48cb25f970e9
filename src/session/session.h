// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "core/image.h"
#include "core/result.h"
#include "deform/applied_history.h"
#include "deform/hit_history.h"
#include "deform/pipeline_kind.h"
#include "physics/physics_world.h"
#include "session/collider_follower.h"
#include "session/constants_setting.h"
#include "session/flight_mode.h"
#include "session/hit_rows.h"
#include "session/read_back.h"
#include "session/scene_presets.h"
#include "session/session_undo.h"
#include "session/shot_schedule.h"
#include "session/shot_tally.h"
#include "session/target.h"
#include "view/camera.h"
#include "view/lights.h"

namespace hitscope {

class FrameCosts;
class TaskList;
class TaskProgress;
class VertexSelection;

/// Everything a person works on: targets, hit history, constants, lights, projectiles. Makes no GL call;
/// SceneGpu follows it on the GPU and hands back what the pipeline made. One thread: the one it was created
/// on.
class Session : public QObject {
    Q_OBJECT
public:
    explicit Session(QObject* parent = nullptr);
    ~Session() override;

    // Scene
    void loadScene(ScenePlan plan);  ///< replaces targets and history
    void loadPaperRow(int row);      ///< likewise; 0 <= row < paperRows().size()
    /// Replaces targets and history by one mesh standing on the floor. `mesh` has passed validate().
    void loadMesh(MeshData mesh, const QString& sourcePath = {});
    void loadMesh(const PreparedMesh& mesh, const QString& sourcePath = {});
    void loadTeapot();
    [[nodiscard]] QString sceneName() const;  ///< for the window's title
    [[nodiscard]] std::span<const std::unique_ptr<Target>> targets() const { return m_targets; }
    [[nodiscard]] const Target* target(TargetId id) const;  ///< null: no such target
    /// World, original shapes; of the hidden ones only if there are no others.
    [[nodiscard]] Bounds sceneBounds() const;
    [[nodiscard]] float floorHeight() const { return m_floorHeight; }
    [[nodiscard]] TargetId selectedTarget() const { return m_selectedTarget; }
    void selectTarget(TargetId id);

    // Targets. Each of these is one step to undo; ids of no target are passed over.
    /// Adds them where they are clear of the others and of the floor (makeRoom()), under names of their own.
    /// The last one is selected.
    void addTargets(std::vector<TargetPlan> plans);
    /// Adds copies as they are now, hits included, beside the others.
    void duplicateTargets(std::span<const TargetId> ids);
    void removeTargets(std::span<const TargetId> ids);  ///< and their hits
    void resetTargets(std::span<const TargetId> ids);   ///< to their original shape: removes their hits
    /// Spaces at the ends are dropped; an empty name is refused.
    [[nodiscard]] Status renameTarget(TargetId id, const QString& name);
    void setTargetsVisible(std::span<const TargetId> ids, bool visible);
    /// Gives them `mesh`, which is theirs but for materials and pictures.
    void setTargetMaterials(std::span<const TargetId> ids, const std::shared_ptr<const MeshData>& mesh);
    /// Hits go along, since they are kept in the local frame. The rotation is made unit. Refused when a
    /// number is not finite or the rotation is none.
    [[nodiscard]] Status setTargetTransform(TargetId id, const RigidTransform& transform,
                                            SessionUndo::Merge merge = SessionUndo::Merge::Never);

    // Hits
    [[nodiscard]] const HitHistory& history() const { return m_history; }
    /// Appends a hit made elsewhere (a file, a script); refused as checkedHit() says, or if there is no such
    /// target.
    [[nodiscard]] Status addHit(const Hit& hit) { return addHits({&hit, 1}); }
    /// Likewise, all or none, and one step to undo.
    [[nodiscard]] Status addHits(std::span<const Hit> hits);
    /// Undo and redo cover every change of the history (hits made, removed, moved, disabled, cleared,
    /// edited), of the constants of hits to come, of the targets and of the lights.
    [[nodiscard]] bool canUndo() const { return m_undo.canUndo(); }
    [[nodiscard]] bool canRedo() const { return m_undo.canRedo(); }
    /// What undo() and redo() would be about; nothing when they would do nothing.
    [[nodiscard]] std::optional<SessionUndo::Name> undoName() const { return nameOf(m_undo.toUndo()); }
    [[nodiscard]] std::optional<SessionUndo::Name> redoName() const { return nameOf(m_undo.toRedo()); }
    void undo();
    void redo();
    /// A gesture has ended: what is done next is another step to undo, whatever it would merge with.
    void finishUndoStep() { m_undo.finishStep(); }
    /// Each of these is one step to undo, however many hits; indices out of range are passed over.
    void setHitsEnabled(std::span<const std::size_t> indices, bool enabled);
    void enableAllHits();
    /// The hits come to stand together, in their order, before the hit that is now at `to` (<= size()).
    void moveHits(std::span<const std::size_t> indices, std::size_t to);
    void removeHits(std::span<const std::size_t> indices);
    void removeHit(std::size_t index);
    void clearHits();
    /// The hit at `index` becomes `hit`. Refused as addHit() does. One step to undo.
    [[nodiscard]] Status replaceHit(std::size_t index, const Hit& hit) {
        return replaceHits({&index, 1}, {&hit, 1}, SessionUndo::Kind::EditHit);
    }
    /// Likewise, all or none: the hit at indices[i] becomes hits[i]. `indices` ascend. `kind` names the step.
    [[nodiscard]] Status replaceHits(std::span<const std::size_t> indices, std::span<const Hit> hits,
                                     SessionUndo::Kind kind,
                                     SessionUndo::Merge merge = SessionUndo::Merge::Never);
    /// The hits get the constants that a hit like each of them is made with now. One step to undo.
    void giveConstants(std::span<const std::size_t> indices);
    void giveConstantsToAll();
    /// Those that giveConstants() would give it.
    [[nodiscard]] DeformationConstants constantsOf(const Hit& hit) const;
    /// Shows the targets as they were after the first `count` hits; nothing: after all. The history stays as
    /// it is, and hits that come end it.
    void showHits(std::optional<std::size_t> count);
    [[nodiscard]] std::span<const Hit> shownHits() const;  ///< the first ones of the history, or all
    [[nodiscard]] bool showsAllHits() const { return !m_shownHits; }
    [[nodiscard]] std::size_t disabledHits() const { return m_disabledHits; }
    [[nodiscard]] std::optional<std::size_t> selectedHit() const { return m_selectedHit; }
    void selectHit(std::optional<std::size_t> index);
    /// The vertices pointed at, picked and selected.
    [[nodiscard]] VertexSelection& selection() { return *m_selection; }
    [[nodiscard]] const VertexSelection& selection() const { return *m_selection; }

    /// What takes a while at the moment.
    [[nodiscard]] TaskList& tasks() const { return *m_tasks; }

    // Settings
    [[nodiscard]] const DeformationConstants& constants() const { return m_constants.constants; }
    [[nodiscard]] const ConstantsSetting& constantsSetting() const { return m_constants; }
    /// Constants of the hits to come; those made keep theirs. One step to undo. Refused when out of range.
    [[nodiscard]] Status setConstants(const DeformationConstants& constants,
                                      SessionUndo::Merge merge = SessionUndo::Merge::Never) {
        return setConstants(ConstantsSetting{constants, m_constants.relative}, merge);
    }
    [[nodiscard]] Status setConstants(const ConstantsSetting& setting,
                                      SessionUndo::Merge merge = SessionUndo::Merge::Never);
    /// Likewise, and nothing to undo: as they were when the program ended.
    [[nodiscard]] Status restoreConstants(const ConstantsSetting& setting);
    /// Those that a hit on this target is made with now.
    [[nodiscard]] DeformationConstants constantsOn(const Target& target) const;
    [[nodiscard]] const Lights& lights() const { return m_lights; }
    /// One step to undo.
    void setLights(const Lights& lights, SessionUndo::Merge merge = SessionUndo::Merge::Never);
    void restoreLights(const Lights& lights);  ///< and nothing to undo
    /// What the lights stand around: the scene as it was opened.
    [[nodiscard]] const LightSpace& lightSpace() const { return m_lightSpace; }
    /// A picture on all targets that have texture coordinates, instead of their own materials; null: none.
    [[nodiscard]] const std::shared_ptr<const Image>& coverTexture() const { return m_coverTexture; }
    void setCoverTexture(std::shared_ptr<const Image> texture);
    [[nodiscard]] const ProjectileSettings& projectileSettings() const { return m_projectileSettings; }
    void setProjectileSettings(const ProjectileSettings& settings);  ///< clamped to projectileParameters()
    /// How shots by hand fly; what is shot by shoot(Ray) and hitscan(Ray) goes by projectileSettings() alone.
    [[nodiscard]] FlightMode flightMode() const { return m_flightMode; }
    void setFlightMode(FlightMode mode);
    [[nodiscard]] PipelineKind pipeline() const { return m_pipeline; }
    void setPipeline(PipelineKind kind);

    // Time
    void shoot(const Ray& ray);  ///< world
    /// A hit without flight, where the ray first meets a target: exact and repeatable. Returns whether there
    /// is one.
    bool hitscan(const Ray& ray);
    /// Now, whatever its delay says; or, where an instant one has to wait for colliders, as soon as they are
    /// there.
    void fire(const ScheduledShot& shot);
    /// The hit that this shot would make if nothing moved meanwhile, as shoot() or, without flight, as
    /// hitscan() makes it. Nothing when it would strike no target.
    [[nodiscard]] std::optional<Hit> predictedHit(const Ray& ray, bool isInstant);
    [[nodiscard]] std::optional<Hit> predictedHit(const ScheduledShot& shot);
    /// Shots that leave by themselves as time goes on.
    void schedule(std::span<const ScheduledShot> shots);
    void cancelScheduled();
    [[nodiscard]] std::size_t shotsToCome() const { return m_schedule.size(); }
    /// advance() had no time for all that is due: shots to fire, or the rest of a step.
    [[nodiscard]] bool isCatchingUp() const { return m_firing != nullptr || m_stepIsBegun; }
    /// What shots strike is the targets with all their dents, by the reference deformation. Colliders take
    /// them on when something comes near; this does it now, as far as there is time. Returns whether all are
    /// up to date.
    bool updateColliders(const IsTimeUp& isTimeUp = {});
    /// Steps the physics; contacts become hits, dynamic targets move. Where time is up before all shots that
    /// are due have been fired and the colliders have taken on their dents, the step and the rest of
    /// `seconds` are dropped and the next call goes on with them: the hits are the same. Some of it is always
    /// done.
    void advance(double seconds, const IsTimeUp& isTimeUp = {});
    void stepOnce();  ///< one physics step, paused or not
    [[nodiscard]] bool isPaused() const { return m_physics.isPaused(); }
    void setPaused(bool paused);
    /// 1: as real time goes; clamped to timeScaleParameter().
    void setTimeScale(double scale);
    void setPhysicsStep(double seconds);  ///< clamped to stepParameter()
    /// Time goes on and something moves with it: projectiles, dynamic targets.
    [[nodiscard]] bool isMoving() const;
    [[nodiscard]] const PhysicsWorld& physics() const { return m_physics; }
    /// One step to undo. Refused for a target too large to be dynamic.
    [[nodiscard]] Status setTargetPhysics(TargetId id, const TargetPhysics& physics);
    /// Why shots pass a target, in words for the interface; empty: they do not.
    [[nodiscard]] QString whyNotHittable(TargetId id) const;

    /// What frames and hits cost; SceneGpu reports there.
    [[nodiscard]] FrameCosts& frameCosts() const { return *m_frameCosts; }

    /// What the renderer reports: what it can, and what the active pipeline made of the targets.
    [[nodiscard]] const ReadBack& readBack() const { return *m_readBack; }
    [[nodiscard]] ReadBack& readBack(ReadBackAccess /*only SceneGpu has it*/) { return *m_readBack; }
    /// Which hits made what is shown, for all that says something about it: the first ones (showHits()), less
    /// those that the pipeline dropped. Valid until either changes.
    [[nodiscard]] AppliedHits appliedHits() const {
        return {m_shownHits.value_or(AppliedHits::kAll), m_readBack->capacity().dropped};
    }
    /// That it is one of them, and enabled; false for one that is not in the history.
    [[nodiscard]] bool isApplied(std::size_t index) const;

Q_SIGNALS:
    void sceneReplaced();  ///< all targets are new, the history is empty
    void targetAdded(hitscope::TargetId target);
    void targetRemoved(hitscope::TargetId target);  ///< its hits went before it
    void targetChanged(hitscope::TargetId target);  ///< name, transform or visibility
    void undoChanged();                             ///< what there is to undo or redo
    void hitsAboutToBeAppended(int first, int last);
    void hitsAppended();
    /// Hits [first, last] are where they were; they were enabled or disabled, or got other constants.
    void hitsChanged(int first, int last);
    void hitsRearranged(const hitscope::HitRows& rows);  ///< removed, put back, moved
    void historyReset();                                 ///< after either of these, and with a new scene
    void constantsChanged();
    void lightsChanged();
    void projectileSettingsChanged();
    void flightModeChanged();
    /// The shots of a click or a series were fired, hit, landed, or are gone; the last time when they are
    /// over.
    void shotsWent(const hitscope::ShotCount& count);
    void pipelineChanged();
    void scheduleChanged();  ///< shotsToCome()
    void aboutToStep();      ///< before each physics step: what is shot now flies with it
    void timeChanged();      ///< paused or not, time scale, physics step
    void targetSelected(hitscope::TargetId target);
    void hitSelected();
    /// showHits(), not the history; with it, or with ReadBack::capacityChanged(), appliedHits() are others.
    void shownHitsChanged();
    void pictureChanged();  ///< anything that a new frame would show

private:
    void clearScene();
    void announceScene(const QString& name);
    TargetState newTarget(TargetPlan plan);
    Target& insertTarget(std::size_t index, const TargetState& state);
    void eraseTarget(std::size_t index);
    void letCollide(const Target& target);
    [[nodiscard]] std::optional<Hit> hitOf(const Impact& impact) const;
    void takeImpacts(std::span<const Impact> impacts);
    TargetId strikeAtOnce(const Ray& ray, const ProjectileSettings& settings);
    void fire(const ScheduledShot& shot, int volley, int series);
    bool fireScheduled(const IsTimeUp& isTimeUp);
    bool step(const IsTimeUp& isTimeUp);
    void sayWhatShotsDid();
    void sayHowFiringGoes(std::size_t due);
    bool beginStep(const IsTimeUp& isTimeUp);
    void expectMoves(std::span<const HistoryEdit> edits);
    void followDynamicTargets();
    [[nodiscard]] std::optional<std::size_t> indexOf(TargetId id) const;
    [[nodiscard]] std::vector<std::size_t> indicesOf(std::span<const TargetId> ids) const;
    [[nodiscard]] std::vector<std::size_t> hitsOn(std::span<const TargetId> ids) const;
    [[nodiscard]] std::set<QString> targetNames() const;
    void appendHits(std::span<const Hit> hits);
    std::vector<HistoryEdit> spliceOut(std::span<const std::size_t> hits);
    void recordUndo(SessionUndo::Change change);
    void changeHistory(std::vector<HistoryEdit> edits, SessionUndo::Name name,
                       SessionUndo::Merge merge = SessionUndo::Merge::Never);
    void changeTargets(std::vector<TargetEdit> targets, SessionUndo::Name name,
                       std::vector<HistoryEdit> edits = {},
                       SessionUndo::Merge merge = SessionUndo::Merge::Never);
    void changeTarget(const Target& target, TargetState after, SessionUndo::Name name,
                      SessionUndo::Merge merge = SessionUndo::Merge::Never);
    void makeAgain(const SessionUndo::Change& change);
    void follow(const SessionUndo::Change& change);
    void follow(const TargetEdit& edit);
    void announceEdits(std::span<const HistoryEdit> edits);
    void announceRows(const HitRows& rows);
    static std::optional<SessionUndo::Name> nameOf(const SessionUndo::Change* change) {
        return change != nullptr ? std::optional(change->name) : std::nullopt;
    }
    void takeConstants(const ConstantsSetting& constants);

    QString m_sceneName;
    std::vector<std::unique_ptr<Target>> m_targets;
    std::uint32_t m_nextTarget = 1;
    float m_floorHeight = 0.0f;
    TargetId m_selectedTarget;
    HitHistory m_history;
    SessionUndo m_undo;
    std::optional<std::size_t> m_selectedHit;
    std::optional<std::size_t> m_shownHits;  ///< nothing: all
    ConstantsSetting m_constants;
    LightSpace m_lightSpace;
    Lights m_lights = defaultLights(m_lightSpace);
    std::shared_ptr<const Image> m_coverTexture;
    ProjectileSettings m_projectileSettings;
    FlightMode m_flightMode = FlightMode::Quick;
    PipelineKind m_pipeline = PipelineKind::TransformFeedback;
    PhysicsWorld m_physics;
    ColliderFollower m_colliders{m_physics};
    ShotSchedule m_schedule;
    ShotTally m_tally;
    bool m_stepIsBegun = false;                 ///< what comes before the next step has been done
    std::map<TargetId, QString> m_notHittable;  ///< why
    std::size_t m_disabledHits = 0;
    std::unique_ptr<ReadBack> m_readBack;
    std::unique_ptr<FrameCosts> m_frameCosts;
    std::unique_ptr<VertexSelection> m_selection;
    std::unique_ptr<TaskList> m_tasks;
    std::unique_ptr<TaskProgress> m_firing;  ///< while shots are due that the frame had no time for
    std::size_t m_mostDue = 0;               ///< of them
};

}  // namespace hitscope
