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

/// Gives all ranges, as far as there is time; returns whether there was.
template <class Give>
bool handOver(ChangedRanges& ranges, const IsTimeUp& isTimeUp, const Give& give) {
    while (!ranges.empty()) {
        for (const VertexRange& range : ranges.take(kBetweenLooks)) {
            give(range);
        }
        if (isTimeUp && isTimeUp() && !ranges.empty()) {
            return false;
        }
    }
    return true;
}

}  // namespace

void ColliderFollower::add(TargetId target, std::shared_ptr<const RenderMesh> shape) {
    Followed& followed = m_targets[target];
    followed = {};
    followed.shape = std::move(shape);
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

/// All dents are taken on: how far they have been applied for questions depends on the time there was.
void ColliderFollower::restore(TargetId target) {
    const auto found = m_targets.find(target);
    if (found == m_targets.end() || !found->second.state) {
        return;
    }
    Followed& followed = found->second;
    followed.state->advance();
    const ReferenceDeformation& state = *followed.state;
    for (const VertexRange& range : state.touched()) {
        m_physics.updateTarget(target, range.first, state.vertices(range));
    }
    update(target, followed, {});
}

void ColliderFollower::beginStep() {
    ++m_steps;
    for (auto& [target, followed] : m_targets) {
        const float reach = followed.farthest.value_or(std::numeric_limits<float>::infinity());
        followed.isDue =
            followed.dueStep && (m_steps >= *followed.dueStep || m_physics.isApproached(target, reach));
    }
}

/// Returns whether all hits are in the state.
bool ColliderFollower::apply(Followed& followed, const IsTimeUp& isTimeUp) {
    const bool isDone = followed.state->advance(isTimeUp);
    const std::vector<VertexRange> changed = followed.state->takeChanged();
    followed.toTake.add(changed);
    followed.toTell.add(changed);
    return isDone;
}

bool ColliderFollower::update(TargetId target, Followed& followed, const IsTimeUp& isTimeUp) {
    if (!followed.dueStep) {
        return true;
    }
    if (!apply(followed, isTimeUp)) {
        return false;
    }
    const bool isTaken = handOver(followed.toTake, isTimeUp, [&](const VertexRange& range) {
        m_physics.updateTarget(target, range.first, followed.state->vertices(range));
    });
    if (!isTaken) {
        return false;
    }
    followed.toTell = {};
    followed.dueStep.reset();
    followed.farthest = 0.0f;
    followed.isDue = false;
    return true;
}

bool ColliderFollower::prepare(TargetId target, Followed& followed, const IsTimeUp& isTimeUp) {
    if (!followed.dueStep) {
        return true;
    }
    if (!apply(followed, isTimeUp)) {
        return false;
    }
    return handOver(followed.toTell, isTimeUp, [&](const VertexRange& range) {
        m_physics.updateForQuestions(target, range.first, followed.state->vertices(range));
    });
}

bool ColliderFollower::updateDue(const IsTimeUp& isTimeUp) {
    return std::all_of(m_targets.begin(), m_targets.end(), [&](auto& entry) {
        return !entry.second.isDue || update(entry.first, entry.second, isTimeUp);
    });
}

bool ColliderFollower::prepareQuestions(const IsTimeUp& isTimeUp) {
    return std::all_of(m_targets.begin(), m_targets.end(),
                       [&](auto& entry) { return prepare(entry.first, entry.second, isTimeUp); });
}

bool ColliderFollower::updateAll(const IsTimeUp& isTimeUp) {
    return std::all_of(m_targets.begin(), m_targets.end(), [&](auto& entry) {
        if (!update(entry.first, entry.second, isTimeUp)) {
            return false;
        }
        m_physics.answerFromWhatIsHit(entry.first);
        return true;
    });
}

bool ColliderFollower::isUpToDate() const {
    return std::none_of(m_targets.begin(), m_targets.end(),
                        [](const auto& entry) { return entry.second.dueStep.has_value(); });
}

}  // namespace hitscope
