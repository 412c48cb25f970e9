// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/collider_follower.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hitscope {

void ColliderFollower::expect(TargetId target, std::optional<float> farthest) {
    Waiting& waiting = m_waiting[target];
    if (!waiting.dueStep) {
        waiting.dueStep = m_steps + std::llround(std::ceil(kDelay / m_physics.step()));
    }
    waiting.farthest =
        waiting.farthest && farthest ? std::optional(*waiting.farthest + *farthest) : std::nullopt;
}

void ColliderFollower::note(TargetId target, const VertexRange& range) {
    m_waiting[target].ranges.add({&range, 1});
}

void ColliderFollower::forget(TargetId target) {
    m_waiting.erase(target);
}

bool ColliderFollower::isDue() {
    ++m_steps;
    bool any = false;
    for (auto& [target, waiting] : m_waiting) {
        const float reach = waiting.farthest.value_or(std::numeric_limits<float>::infinity());
        waiting.isDue =
            waiting.dueStep && (m_steps >= *waiting.dueStep || m_physics.isApproached(target, reach));
        any = any || waiting.isDue;
    }
    return any;
}

void ColliderFollower::update(TargetId target, Waiting& waiting, const Vertices& vertices) {
    const std::span<const DynamicVertex> all = vertices(target);
    for (const VertexRange& range : waiting.ranges.take()) {
        if (std::size_t{range.first} + range.count <= all.size()) {
            m_physics.updateTarget(target, range.first, all.subspan(range.first, range.count));
        }
    }
}

void ColliderFollower::updateDue(const Vertices& vertices) {
    for (auto it = m_waiting.begin(); it != m_waiting.end();) {
        if (it->second.isDue) {
            update(it->first, it->second, vertices);
            it = m_waiting.erase(it);
        } else {
            ++it;
        }
    }
}

void ColliderFollower::updateAll(const Vertices& vertices) {
    for (auto& [target, waiting] : m_waiting) {
        update(target, waiting, vertices);
    }
}

}  // namespace hitscope
