// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>

#include "core/ids.h"
#include "deform/hits_by_target.h"
#include "deform/reference.h"
#include "deform/vertex_range.h"
#include "mesh/render_mesh.h"
#include "physics/physics_world.h"

namespace hitscope {

/// Makes colliders follow the history, by the reference deformation: what is struck depends on the hits
/// alone, not on the renderer, the pipeline and its capacity, or which hits are shown.
///
/// A collider takes its dents on at a physics step that depends on the hits and projectiles alone: before a
/// projectile that has not struck the target comes near it, and kDelay after the hit at the latest, so that
/// hits soon after each other are worked on together. Who asks in between, to aim or to paint, does not wait
/// and does not change that: prepareQuestions() lets PhysicsWorld answer with all dents.
class ColliderFollower {
public:
    /// `physics` outlives this.
    explicit ColliderFollower(PhysicsWorld& physics) : m_physics(physics) {}

    /// A target without hits.
    void add(TargetId target, std::shared_ptr<const RenderMesh> shape);
    /// The target is gone, and its hits before it.
    void forget(TargetId target);
    void clear();
    /// The history has been edited so, in the order made.
    void follow(std::span<const HistoryEdit> edits);
    /// The target's collider takes its dents on at the next step.
    void hurry(TargetId target);
    /// The target's collider has been made anew, from the original shape.
    void restore(TargetId target);

    /// Before each step: which colliders it needs up to date.
    void beginStep();
    /// Brings those up to date, as far as there is time; returns whether they are.
    bool updateDue(const IsTimeUp& isTimeUp);
    /// Lets PhysicsWorld answer questions with all dents, as far as there is time; returns whether it does.
    /// What is hit, and when it takes dents on, stays as it is.
    bool prepareQuestions(const IsTimeUp& isTimeUp);
    /// Brings all colliders up to date: right for an instant shot, which belongs to its step, and whenever
    /// nothing moves that could notice when.
    bool updateAll(const IsTimeUp& isTimeUp = {});
    [[nodiscard]] bool isUpToDate() const;

    static constexpr double kDelay = 0.025;  ///< seconds of simulated time: six steps of the usual length

private:
    struct Followed {
        std::shared_ptr<const RenderMesh> shape;
        std::unique_ptr<ReferenceDeformation> state;  ///< null: it has had no hit
        ChangedRanges toTake;                         ///< applied, and not in the collider yet
        ChangedRanges toTell;                         ///< likewise not in what answers questions
        std::optional<std::int64_t> dueStep;          ///< nothing: it is up to date
        /// Metres: vertices have moved by no more since it was up to date; nothing: there is no telling.
        std::optional<float> farthest = 0.0f;
        bool isDue = false;
    };
    void note(const TargetHitsEdit& edit);
    bool apply(Followed& followed, const IsTimeUp& isTimeUp);
    bool update(TargetId target, Followed& followed, const IsTimeUp& isTimeUp);
    bool prepare(TargetId target, Followed& followed, const IsTimeUp& isTimeUp);

    PhysicsWorld& m_physics;
    HitsByTarget m_hits;
    std::int64_t m_steps = 0;  ///< begun
    std::map<TargetId, Followed> m_targets;
};

}  // namespace hitscope
