// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/collider_follower.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "deform/dent_shape.h"

namespace hitscope {

namespace {

constexpr std::uint32_t kBetweenLooks = 256 * kClusterVertices;  // about 1 ms

/// The first vertices of the ranges, at most so many; they are taken out of them. `ranges` is not empty.
VertexRange takeSome(std::deque<VertexRange>& ranges, std::uint32_t most) {
    VertexRange& next = ranges.front();
    const VertexRange some{next.first, std::min(next.count, most)};
    next.first += some.count;
    next.count -= some.count;
    if (next.count == 0) {
        ranges.pop_front();
    }
    return some;
}

}  // namespace

void ColliderFollower::add(TargetId target, std::shared_ptr<const RenderMesh> shape) {
    Followed& followed = m_targets[target];
    followed = {std::move(shape), nullptr, {}, {}, 0.0f, false};
}

void ColliderFollower::forget(TargetId target) {
    m_targets.erase(target);
}

void ColliderFollower::clear() {
    m_targets.clear();
    m_hits.reset({});
}

void ColliderFollower::follow(std::span<const HistoryEdit> edits) {
    for (const HistoryEdit& edit : edits) {
        for (const TargetHitsEdit& change : m_hits.apply(edit)) {
            note(change);
        }
    }
}

void ColliderFollower::note(const TargetHitsEdit& edit) {
    const auto found = m_targets.find(edit.target);
    if (found == m_targets.end()) {
        return;
    }
    Followed& followed = found->second;
    if (!followed.state) {
        followed.state = std::make_unique<ReferenceDeformation>(*followed.shape);
    }
    followed.state->edit(edit);
    if (!followed.dueStep) {
        followed.dueStep = m_steps + std::llround(kDelay / m_physics.clock().step());
    }
    const bool appends =
        edit.before.empty() && edit.first + edit.after.size() == m_hits.of(edit.target).size();
    if (!appends) {
        followed.farthest.reset();
    }
    for (const Hit& hit : edit.after) {
        if (followed.farthest) {
            *followed.farthest += farthestPush(hit);
        }
    }
}

void ColliderFollower::hurry(TargetId target) {
    const auto found = m_targets.find(target);
    if (found != m_targets.end() && found->second.dueStep) {
        found->second.dueStep = m_steps;
        found->second.isDue = true;
    }
}

void ColliderFollower::restore(TargetId target) {
    const auto found = m_targets.find(target);
    if (found != m_targets.end() && found->second.state) {
        const ReferenceDeformation& state = *found->second.state;
        for (const VertexRange& range : state.touched()) {
            m_physics.updateTarget(target, range.first, state.vertices(range));
        }
    }
}

void ColliderFollower::beginStep() {
    ++m_steps;
    for (auto& [target, followed] : m_targets) {
        const float reach = followed.farthest.value_or(std::numeric_limits<float>::infinity());
        followed.isDue =
            followed.dueStep && (m_steps >= *followed.dueStep || m_physics.isApproached(target, reach));
    }
}

bool ColliderFollower::update(TargetId target, Followed& followed, const IsTimeUp& isTimeUp) {
    if (!followed.dueStep) {
        return true;
    }
    if (!followed.state->advance(isTimeUp)) {
        return false;
    }
    const std::vector<VertexRange> changed = followed.state->takeChanged();
    followed.toTake.insert(followed.toTake.end(), changed.begin(), changed.end());
    while (!followed.toTake.empty()) {
        const VertexRange some = takeSome(followed.toTake, kBetweenLooks);
        m_physics.updateTarget(target, some.first, followed.state->vertices(some));
        if (isTimeUp && isTimeUp() && !followed.toTake.empty()) {
            return false;
        }
    }
    followed.dueStep.reset();
    followed.farthest = 0.0f;
    followed.isDue = false;
    return true;
}

bool ColliderFollower::updateDue(const IsTimeUp& isTimeUp) {
    return std::all_of(m_targets.begin(), m_targets.end(), [&](auto& entry) {
        return !entry.second.isDue || update(entry.first, entry.second, isTimeUp);
    });
}

bool ColliderFollower::updateAll(const IsTimeUp& isTimeUp) {
    return std::all_of(m_targets.begin(), m_targets.end(),
                       [&](auto& entry) { return update(entry.first, entry.second, isTimeUp); });
}

bool ColliderFollower::isUpToDate() const {
    return std::none_of(m_targets.begin(), m_targets.end(),
                        [](const auto& entry) { return entry.second.dueStep.has_value(); });
}

}  // namespace hitscope
