// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/hits_by_target.h"

#include <algorithm>
#include <utility>

#include "core/offset.h"

namespace hitscope {

namespace {

TargetHitsEdit& editOf(std::vector<TargetHitsEdit>& edits, TargetId target) {
    const auto known = std::find_if(edits.begin(), edits.end(),
                                    [target](const TargetHitsEdit& edit) { return edit.target == target; });
    return known != edits.end() ? *known : edits.emplace_back(TargetHitsEdit{target, 0, {}, {}});
}

/// Leaves out what is the same on both sides.
void trim(TargetHitsEdit& edit) {
    const auto [before, after] =
        std::mismatch(edit.before.begin(), edit.before.end(), edit.after.begin(), edit.after.end());
    edit.first += static_cast<std::size_t>(before - edit.before.begin());
    edit.before.erase(edit.before.begin(), before);
    edit.after.erase(edit.after.begin(), after);
    while (!edit.before.empty() && !edit.after.empty() && edit.before.back() == edit.after.back()) {
        edit.before.pop_back();
        edit.after.pop_back();
    }
}

Hit withoutGroup(Hit hit) {
    hit.group = {};
    return hit;
}

}  // namespace

std::size_t HitsByTarget::enabledBefore(std::size_t index, TargetId target) const {
    if (index == m_places.size()) {
        return of(target).size();
    }
    return static_cast<std::size_t>(
        std::count_if(m_places.begin(), m_places.begin() + offset(index),
                      [target](const Place& place) { return place.enabled && place.target == target; }));
}

std::vector<TargetHitsEdit> HitsByTarget::apply(const HistoryEdit& edit) {
    std::vector<TargetHitsEdit> edits;
    // Groups deform nothing: who deforms sees no change where only they are others.
    for (const Hit& hit : edit.before) {
        if (hit.enabled) {
            editOf(edits, hit.target).before.push_back(withoutGroup(hit));
        }
    }
    for (const Hit& hit : edit.after) {
        if (hit.enabled) {
            editOf(edits, hit.target).after.push_back(withoutGroup(hit));
        }
    }
    for (TargetHitsEdit& change : edits) {
        change.first = enabledBefore(edit.first, change.target);
        trim(change);
        std::vector<Hit>& hits = m_hits[change.target];
        const auto at = hits.erase(hits.begin() + offset(change.first),
                                   hits.begin() + offset(change.first + change.before.size()));
        hits.insert(at, change.after.begin(), change.after.end());
    }
    std::erase_if(edits,
                  [](const TargetHitsEdit& change) { return change.before.empty() && change.after.empty(); });

    std::vector<Place> places;
    places.reserve(edit.after.size());
    for (const Hit& hit : edit.after) {
        places.push_back({hit.target, hit.enabled});
    }
    const auto at = m_places.erase(m_places.begin() + offset(edit.first),
                                   m_places.begin() + offset(edit.first + edit.before.size()));
    m_places.insert(at, places.begin(), places.end());
    return edits;
}

void HitsByTarget::reset(std::span<const Hit> history) {
    m_places.clear();
    m_hits.clear();
    apply({0, {}, {history.begin(), history.end()}});
}

std::span<const Hit> HitsByTarget::of(TargetId target) const {
    const auto known = m_hits.find(target);
    return known == m_hits.end() ? std::span<const Hit>() : std::span<const Hit>(known->second);
}

}  // namespace hitscope
