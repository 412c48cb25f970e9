// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "core/ids.h"
#include "deform/vertex_range.h"
#include "mesh/render_mesh.h"
#include "physics/physics_world.h"

namespace hitscope {

/// Decides when colliders take on what hits made of their targets.
///
/// What the pipeline made comes back when the GPU and the window's frames have time for it; a collider that
/// took it on just then would make the next impacts depend on how fast frames followed each other. So a
/// collider takes it on at a physics step that depends on the hits and projectiles alone: before a projectile
/// that has not struck the target comes near it, and kDelay after the hit at the latest. By then it has
/// usually been read back; where it has not, whoever steps must wait for it (isDue()).
class ColliderFollower {
public:
    /// `physics` outlives this.
    explicit ColliderFollower(PhysicsWorld& physics) : m_physics(physics) {}

    /// Vertices of a target will move, by no more than `farthest` metres; nothing: there is no telling.
    void expect(TargetId target, std::optional<float> farthest);
    /// These have been read back: current render vertices of the target are there to be taken on.
    void note(TargetId target, const VertexRange& range);
    /// The target is gone.
    void forget(TargetId target);
    void clear() { m_waiting.clear(); }

    /// Before each step: whether colliders must take on now all hits made so far.
    [[nodiscard]] bool isDue();
    using Vertices = std::function<std::span<const DynamicVertex>(TargetId)>;
    /// Those that isDue() found take on what has been noted.
    void updateDue(const Vertices& vertices);
    /// All do: right whenever nothing moves that could notice when.
    void updateAll(const Vertices& vertices);

    static constexpr double kDelay = 0.05;  ///< seconds of simulated time: three frames at 60 a second

private:
    struct Waiting {
        std::optional<std::int64_t> dueStep;  ///< nothing: nothing is expected
        std::optional<float> farthest = 0.0f;
        ChangedRanges ranges;
        bool isDue = false;
    };
    void update(TargetId target, Waiting& waiting, const Vertices& vertices);

    PhysicsWorld& m_physics;
    std::int64_t m_steps = 0;  ///< counted by isDue()
    std::map<TargetId, Waiting> m_waiting;
};

}  // namespace hitscope
