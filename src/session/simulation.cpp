// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/simulation.h"

#include <QElapsedTimer>
#include <algorithm>

#include "session/frame_costs.h"
#include "session/paced_advance.h"
#include "session/session.h"
#include "session/task_list.h"
#include "session/usual_dent.h"

namespace hitscope {

namespace {

Hit localHit(const Impact& impact) {
    Hit hit;
    hit.target = impact.target;
    hit.point = impact.where.toLocal(impact.point);
    hit.direction = impact.where.directionToLocal(impact.direction);
    hit.normal = impact.where.directionToLocal(impact.normal);
    hit.triangle = impact.triangle;
    hit.time = impact.time;
    hit.speed = impact.speed;
    hit.impulse = impact.impulse;
    return hit;
}

constexpr float kWholeWorld = 2.0e7f;  // metres: longer than any line between two usable points

}  // namespace

Simulation::Simulation(Session& session) : m_session(session) {}

Simulation::~Simulation() = default;

// Shots

void Simulation::shoot(const Ray& ray) {
    fire({0.0, ray, m_session.m_settings.projectile(), false});
}

bool Simulation::hitscan(const Ray& ray) {
    const std::size_t before = m_session.m_hits.history().size();
    m_colliders.updateAll();
    fire({0.0, ray, m_session.m_settings.projectile(), true});
    return m_session.m_hits.history().size() > before;
}

void Simulation::fire(const ScheduledShot& shot) {
    if (shot.isInstant && !isPaused() && !m_colliders.updateAll(workLimit())) {
        ScheduledShot next = shot;
        next.delay = 0.0;
        schedule({&next, 1});
        return;
    }
    fire(shot, 0, m_tally.begin(1));
    sayWhatShotsDid();
    Q_EMIT m_session.pictureChanged();
}

void Simulation::fire(const ScheduledShot& shot, int volley, int series) {
    const Ray& ray = shot.ray;
    if (!shot.isInstant) {
        m_tally.launched(series, m_physics.shoot(ray.origin, ray.direction, shot.settings, volley));
        return;
    }
    const TargetId struck = strikeAtOnce(ray, shot.settings);
    const bool floor = !struck && m_physics.castRay(ray.origin, ray.direction, kWholeWorld).has_value();
    m_tally.struckAtOnce(series, struck, floor);
}

/// 0: no hit was made.
TargetId Simulation::strikeAtOnce(const Ray& ray, const ProjectileSettings& settings) {
    m_colliders.updateAll();
    const auto impact = m_physics.hitscan(ray.origin, ray.direction, settings);
    const std::size_t before = m_session.m_hits.history().size();
    if (impact) {
        takeImpacts({&*impact, 1}, dynamicPlaces());
    }
    return m_session.m_hits.history().size() > before ? impact->target : TargetId{};
}

std::optional<Hit> Simulation::predictedHit(const Ray& ray, bool isInstant) {
    return predictedHit({0.0, ray, m_session.m_settings.projectile(), isInstant});
}

std::optional<Hit> Simulation::predictedHit(const ScheduledShot& shot) {
    updateColliders({});
    const auto impact = m_physics.predict(shot.ray.origin, shot.ray.direction, shot.settings, shot.isInstant);
    return impact ? hitOf(*impact) : std::nullopt;
}

void Simulation::schedule(std::span<const ScheduledShot> shots) {
    if (!shots.empty()) {
        m_schedule.add(shots, m_physics.clock().time(), m_tally.begin(shots.size()));
        sayWhatShotsDid();
    }
    Q_EMIT scheduleChanged();
    Q_EMIT m_session.pictureChanged();
}

void Simulation::cancelScheduled() {
    m_schedule.clear();
    m_tally.stopFiring();
    sayHowFiringGoes(0);
    sayWhatShotsDid();
    Q_EMIT scheduleChanged();
}

bool Simulation::recallShots() {
    if (m_stepIsBegun || !hasShotsInAir()) {
        return false;
    }
    cancelScheduled();
    for (const ProjectileId projectile : m_tally.recall()) {
        m_physics.removeProjectile(projectile);
    }
    sayWhatShotsDid();
    Q_EMIT m_session.pictureChanged();
    return true;
}

void Simulation::sayWhatShotsDid() {
    for (const ShotCount& count : m_tally.takeChanged()) {
        Q_EMIT shotsWent(count);
    }
}

/// Nothing for an impact that no hit can be made of.
std::optional<Hit> Simulation::hitOf(const Impact& impact) const {
    Hit hit = localHit(impact);
    hit.constants = usualConstants(m_session, hit);
    hit.form = impact.form ? withRadius(m_session, *impact.form, hit, impact.radius)
                           : usualForm(m_session, hit, impact.radius);
    hit.pipeline = static_cast<std::uint8_t>(m_session.m_settings.pipeline());
    Result<Hit> checked = checkedHit(hit);
    return checked && m_session.m_targets.find(impact.target) != nullptr ? std::optional(checked.value())
                                                                         : std::nullopt;
}

void Simulation::takeImpacts(std::span<const Impact> impacts, std::vector<TargetPlace> places) {
    std::vector<Hit> hits;
    bool movesTargets = false;
    for (const Impact& impact : impacts) {
        if (const std::optional<Hit> hit = hitOf(impact)) {
            hits.push_back(*hit);
            m_tally.hit(impact.projectile, impact.target);
            movesTargets = movesTargets || m_session.m_targets.find(impact.target)->physics.isDynamic;
        }
    }
    if (!movesTargets) {
        places.clear();
    }
    m_session.m_hits.append(hits, SessionUndo::Kind::Hit, SessionUndo::Merge::Never, std::move(places));
}

// Colliders

/// What moves would notice when a collider takes its dents on, so that questions are answered from a second
/// surface then. A dynamic target that has another shape wakes: whoever advances what moves is told.
bool Simulation::updateColliders(const IsTimeUp& isTimeUp) {
    if (m_physics.isMoving() || m_physics.isMidStep()) {
        return m_colliders.prepareQuestions(isTimeUp);
    }
    const bool wasMoving = isMoving();
    const bool isDone = m_colliders.updateAll(isTimeUp);
    if (!wasMoving && isMoving()) {
        Q_EMIT m_session.pictureChanged();
    }
    return isDone;
}

// Time

/// Between steps, so that an instant shot finds the dents of those before it. Returns whether all that are
/// due have been fired.
bool Simulation::fireScheduled(const IsTimeUp& isTimeUp) {
    const double now = m_physics.clock().time();
    const double length = m_physics.clock().step();
    bool anyFired = false;
    while (m_schedule.isDue(now, length) && !(anyFired && isTimeUp && isTimeUp())) {
        if (m_schedule.isNextInstant() && !m_colliders.updateAll(isTimeUp)) {
            break;
        }
        const ShotSchedule::Due due = m_schedule.takeNext();
        fire(due.shot, due.volley, due.series);
        anyFired = true;
    }
    const std::size_t left = m_schedule.countDue(now, length);
    sayHowFiringGoes(left);
    if (anyFired) {
        Q_EMIT scheduleChanged();
    }
    return left == 0;
}

/// `due`: shots that the frame had no time for.
void Simulation::sayHowFiringGoes(std::size_t due) {
    if (due == 0) {
        m_firing.reset();
        return;
    }
    if (!m_firing) {
        m_mostDue = due;
        m_firing = std::make_unique<TaskProgress>(
            *m_session.m_tasks, tr("Shooting"), [this] { cancelScheduled(); },
            tr("Pending shots are dropped; hits made so far stay."));
    }
    m_mostDue = std::max(m_mostDue, due);
    m_firing->report(1.0 - static_cast<double>(due) / static_cast<double>(m_mostDue));
}

/// What comes before a step, once. Returns whether all of it is done: all shots that are due have been fired.
bool Simulation::beginStep(const IsTimeUp& isTimeUp) {
    if (!m_stepIsBegun) {
        if (!fireScheduled(isTimeUp)) {
            return false;
        }
        Q_EMIT aboutToStep();
        m_colliders.beginStep();
        m_placesBefore = dynamicPlaces();
        m_stepIsBegun = true;
    }
    return true;
}

/// Returns whether it was made: not before all shots that are due have been fired, and the colliders that it
/// needs have taken on their dents.
bool Simulation::step(const IsTimeUp& isTimeUp) {
    if (!beginStep(isTimeUp)) {
        sayWhatShotsDid();
        return false;
    }
    QElapsedTimer clock;
    clock.start();
    if (!m_physics.isMidStep() && !m_colliders.updateDue(isTimeUp)) {
        return false;
    }
    const std::optional<std::vector<Impact>> impacts = m_physics.takeStep(isTimeUp);
    m_session.m_frameCosts->addPhysics(static_cast<double>(clock.nsecsElapsed()) * 1.0e-9);
    if (!impacts) {
        return false;
    }
    m_stepIsBegun = false;
    takeImpacts(*impacts, std::move(m_placesBefore));
    for (const PhysicsWorld::FlightEvent& event : m_physics.takeFlightEvents()) {
        m_tally.follow(event);
    }
    sayWhatShotsDid();
    return true;
}

void Simulation::advance(double seconds, const IsTimeUp& isTimeUp) {
    const bool wasMoving = isMoving();
    for (int steps = m_physics.clock().stepsDue(seconds); steps > 0 && step(isTimeUp); --steps) {
    }
    if (wasMoving) {
        followDynamicTargets();
        Q_EMIT m_session.pictureChanged();
    }
}

void Simulation::stepOnce() {
    m_physics.clock().showLastStep();
    step({});
    followDynamicTargets();
    Q_EMIT m_session.pictureChanged();
}

void Simulation::setPaused(bool paused) {
    if (paused != m_physics.clock().isPaused()) {
        m_physics.clock().setPaused(paused);
        Q_EMIT timeChanged();
        Q_EMIT m_session.pictureChanged();
    }
}

void Simulation::setTime(double seconds) {
    m_physics.clock().setTime(seconds);
}

void Simulation::setTimeScale(double scale) {
    m_physics.clock().setTimeScale(scale);
    Q_EMIT timeChanged();
}

void Simulation::setStep(double seconds) {
    m_physics.clock().setStep(seconds);
    Q_EMIT timeChanged();
}

bool Simulation::isMoving() const {
    return !m_physics.clock().isPaused() && (m_physics.isMoving() || m_schedule.size() > 0);
}

}  // namespace hitscope
