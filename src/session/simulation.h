// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "deform/hit_history.h"
#include "physics/physics_world.h"
#include "session/collider_follower.h"
#include "session/shots/shot_schedule.h"
#include "session/shots/shot_tally.h"
#include "session/target.h"

namespace hitscope {

class Session;
class TaskProgress;

/// Shots and time in a session: what flies, what it strikes, what is knocked about. What is struck becomes
/// hits of the session.
class Simulation : public QObject {
    Q_OBJECT
public:
    explicit Simulation(Session& session);  ///< `session` owns it
    ~Simulation() override;

    [[nodiscard]] const PhysicsWorld& physics() const { return m_physics; }
    /// Why shots pass a target, in words for the interface; empty: they do not.
    [[nodiscard]] QString whyNotHittable(TargetId id) const;

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
    /// There are shots that have struck nothing so far.
    [[nodiscard]] bool hasShotsInAir() const { return m_tally.hasShotsInAir(); }
    /// Takes these back, and cancels those that are scheduled. Returns whether there were some in the air; in
    /// the middle of a step, which may be theirs, it does nothing.
    bool recallShots();
    [[nodiscard]] std::size_t shotsToCome() const { return m_schedule.size(); }

    /// Steps the physics; contacts become hits, dynamic targets move. Where time is up before all shots that
    /// are due have been fired and the colliders have taken on their dents, the step and the rest of
    /// `seconds` are dropped and the next call goes on with them: the hits are the same. Some of it is always
    /// done.
    void advance(double seconds, const IsTimeUp& isTimeUp = {});
    void stepOnce();  ///< one physics step, paused or not
    /// advance() had no time for all that is due: shots to fire, or the rest of a step.
    [[nodiscard]] bool isCatchingUp() const { return m_firing != nullptr || m_stepIsBegun; }
    /// What shots strike is the targets with all their dents, by the reference deformation. Colliders take
    /// them on when something comes near. Afterwards predictedHit(), and physics() where it is asked, know
    /// all of them, as far as there was time; returns whether they do. While something moves, the colliders
    /// themselves are left alone: hits do not depend on when or how often this is called.
    bool updateColliders(const IsTimeUp& isTimeUp = {});
    /// Dynamic targets that stay where they are put, whatever strikes them, until the next call; ids of no
    /// dynamic target are passed over.
    void hold(std::span<const TargetId> ids);
    /// Time goes on and something moves with it: projectiles, dynamic targets.
    [[nodiscard]] bool isMoving() const;
    [[nodiscard]] bool isPaused() const { return m_physics.clock().isPaused(); }
    void setPaused(bool paused);
    /// 1: as real time goes; clamped to timeScaleParameter().
    void setTimeScale(double scale);
    void setTime(double seconds);  ///< of physics(), while nothing flies
    void setStep(double seconds);  ///< of the physics; clamped to stepParameter()

Q_SIGNALS:
    /// The shots of a click or a series were fired, hit, landed, or are gone; the last time when they are
    /// over.
    void shotsWent(const hitscope::ShotCount& count);
    void scheduleChanged();  ///< shotsToCome()
    void aboutToStep();      ///< before each physics step: what is shot now flies with it
    void timeChanged();      ///< paused or not, time scale, physics step

private:
    friend class Session;
    friend class SessionTargets;

    void clear();
    void setFloor(float height);
    /// A target has come, with a collider of its original shape.
    void add(const Target& target);
    void forget(TargetId target);
    /// Puts it where it is now, or takes it out if it is hidden.
    void letCollide(const Target& target);
    [[nodiscard]] TargetPhysics physicsOf(const Target& target) const;  ///< now
    [[nodiscard]] Status setTargetPhysics(TargetId id, const TargetPhysics& physics);
    /// The history has these edits now.
    void follow(std::span<const HistoryEdit> edits) { m_colliders.follow(edits); }

    [[nodiscard]] std::vector<TargetPlace> dynamicPlaces() const;
    /// Puts dynamic targets there, at rest; ids of no dynamic target are passed over.
    void putBack(std::span<const TargetPlace> places);
    /// The history has the hits that belong to these places: the next step finds the targets in that shape,
    /// and none that a dent keeps off the floor.
    void shapeAt(std::span<const TargetPlace> places);

    [[nodiscard]] std::optional<Hit> hitOf(const Impact& impact) const;
    /// `places`: where the dynamic targets were before them.
    void takeImpacts(std::span<const Impact> impacts, std::vector<TargetPlace> places);
    TargetId strikeAtOnce(const Ray& ray, const ProjectileSettings& settings);
    void fire(const ScheduledShot& shot, int volley, int series);
    bool fireScheduled(const IsTimeUp& isTimeUp);
    bool beginStep(const IsTimeUp& isTimeUp);
    bool step(const IsTimeUp& isTimeUp);
    void sayWhatShotsDid();
    void sayHowFiringGoes(std::size_t due);
    void followDynamicTargets();

    Session& m_session;
    PhysicsWorld m_physics;
    ColliderFollower m_colliders{m_physics};
    ShotSchedule m_schedule;
    ShotTally m_tally;
    bool m_stepIsBegun = false;                 ///< what comes before the next step has been done
    std::vector<TargetPlace> m_placesBefore;    ///< of the dynamic targets, before the step that is begun
    std::map<TargetId, QString> m_notHittable;  ///< why
    std::set<TargetId> m_held;
    std::unique_ptr<TaskProgress> m_firing;  ///< while shots are due that the frame had no time for
    std::size_t m_mostDue = 0;               ///< of them
};

}  // namespace hitscope
