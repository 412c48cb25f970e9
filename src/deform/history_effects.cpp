// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/history_effects.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace hitscope {

void HistoryEffects::followShapes(const Shapes& shapes) {
    for (const auto& [id, shape] : shapes) {
        if (shape) {
            m_shapes[id] = shape;
        } else {
            m_shapes.erase(id);
        }
    }
}

HistoryEffects::Changes HistoryEffects::follow(std::span<const HistoryEdit> edits, const Shapes& shapes,
                                               const std::atomic<bool>& stop) {
    followShapes(shapes);
    std::map<TargetId, std::vector<TargetHitsEdit>> work;
    for (const auto& [id, shape] : shapes) {
        work[id];  // its hits may have come before it did
    }
    for (const HistoryEdit& edit : edits) {
        for (TargetHitsEdit& change : m_hits.apply(edit)) {
            work[change.target].push_back(std::move(change));
        }
    }
    Changes changes;
    ChangedHits changed;
    for (const auto& [target, made] : work) {
        if (shapes.contains(target) && m_targets.erase(target) > 0) {
            changes.counts.push_back({target, true, {}, {}});
        }
        follow(target, made, stop, changed, changes);
    }
    if (!stop) {
        changes.rows = rowsOf(std::move(changed), madeBy(edits));
    }
    return changes;
}

/// Where the hits stand in the end that the edits brought, also those that they only moved.
std::vector<HistoryEffects::Rows> HistoryEffects::madeBy(std::span<const HistoryEdit> edits) {
    std::vector<Rows> made;
    for (const HistoryEdit& edit : edits) {
        const std::size_t end = edit.first + edit.before.size();
        for (Rows& rows : made) {
            if (rows.end > edit.first) {
                const bool isBehind = rows.first >= end;
                rows.end = std::max(rows.end, end) - edit.before.size() + edit.after.size();
                rows.first = isBehind ? rows.first - edit.before.size() + edit.after.size()
                                      : std::min(rows.first, edit.first);
            }
        }
        if (!edit.after.empty()) {
            made.push_back({edit.first, edit.first + edit.after.size()});
        }
    }
    return made;
}

void HistoryEffects::follow(TargetId target, std::span<const TargetHitsEdit> edits,
                            const std::atomic<bool>& stop, ChangedHits& changed, Changes& changes) {
    const std::span<const Hit> hits = m_hits.of(target);
    const auto shape = m_shapes.find(target);
    if (hits.empty() || shape == m_shapes.end()) {
        if (m_targets.erase(target) > 0) {
            changes.counts.push_back({target, true, {}, {}});
        }
        return;
    }
    auto known = m_targets.find(target);
    const bool isNew = known == m_targets.end();
    TargetEffects::Changes made;
    if (isNew) {
        known = m_targets.emplace(target, TargetEffects(shape->second)).first;
        const TargetHitsEdit all{target, 0, {}, {hits.begin(), hits.end()}};
        made = known->second.follow({&all, 1}, hits, stop);
    } else if (!edits.empty()) {
        made = known->second.follow(edits, hits, stop);
    }
    if (!made.hits.empty()) {
        changed[target] = std::move(made.hits);
    }
    if (isNew || !made.vertices.empty()) {
        Changes::Counts counts{target, isNew, std::move(made.vertices), {}};
        counts.counts.reserve(counts.vertices.size());
        for (const std::uint32_t vertex : counts.vertices) {
            counts.counts.push_back(known->second.counts()[vertex]);
        }
        changes.counts.push_back(std::move(counts));
    }
}

/// From the last row back, since what has changed is mostly near the end.
std::vector<HistoryEffects::Changes::Row> HistoryEffects::rowsOf(ChangedHits changed,
                                                                 std::span<const Rows> made) const {
    std::size_t first = m_hits.places().size();
    for (const Rows& rows : made) {
        first = std::min(first, rows.first);
    }
    std::vector<bool> isMade(m_hits.places().size() - first, false);
    for (const Rows& rows : made) {
        std::fill(isMade.begin() + static_cast<std::ptrdiff_t>(rows.first - first),
                  isMade.begin() + static_cast<std::ptrdiff_t>(rows.end - first), true);
    }
    std::size_t left = 0;
    std::unordered_map<TargetId, std::uint32_t> next;  // hits of the target up to the row
    for (const auto& [target, effects] : m_targets) {
        next[target] = static_cast<std::uint32_t>(effects.effects().size());
        left += changed[target].size();
    }
    std::vector<Changes::Row> found;
    for (std::size_t row = m_hits.places().size(); row > 0 && (left > 0 || row > first); --row) {
        const HitsByTarget::Place& place = m_hits.places()[row - 1];
        const auto known = place.enabled ? next.find(place.target) : next.end();
        if (known == next.end()) {
            continue;
        }
        const std::uint32_t hit = --known->second;
        std::vector<std::uint32_t>& hits = changed[place.target];
        const bool isChanged = !hits.empty() && hits.back() == hit;
        if (isChanged) {
            hits.pop_back();
            --left;
        }
        if (isChanged || (row > first && isMade[row - 1 - first])) {
            found.push_back({static_cast<std::uint32_t>(row - 1), m_targets.at(place.target).effects()[hit]});
        }
    }
    std::reverse(found.begin(), found.end());
    return found;
}

std::vector<std::uint32_t> HistoryEffects::movedBy(std::size_t row) const {
    if (row >= m_hits.places().size() || !m_hits.places()[row].enabled) {
        return {};
    }
    const TargetId target = m_hits.places()[row].target;
    const TargetEffects* effects = of(target);
    std::size_t index = 0;
    for (const HitsByTarget::Place& place : m_hits.places().first(row)) {
        index += place.enabled && place.target == target ? 1 : 0;
    }
    return effects == nullptr ? std::vector<std::uint32_t>() : effects->movedBy(index, m_hits.of(target));
}

const TargetEffects* HistoryEffects::of(TargetId target) const {
    const auto known = m_targets.find(target);
    return known == m_targets.end() ? nullptr : &known->second;
}

}  // namespace hitscope
