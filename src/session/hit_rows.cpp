// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/hit_rows.h"

#include <algorithm>
#include <deque>
#include <functional>
#include <limits>
#include <numeric>
#include <unordered_map>

namespace hitscope {

namespace {

constexpr std::uint32_t kNowhere = std::numeric_limits<std::uint32_t>::max();

std::size_t hashOf(const Hit& hit) {
    std::size_t hash = std::hash<double>()(hit.time);
    for (const float part : {hit.point.x, hit.point.y, hit.point.z}) {
        hash = hash * 31 + std::hash<float>()(part);
    }
    return hash;
}

/// The hits taken out so far, to be found again when they are put back in.
class TakenHits {
public:
    /// `rows` are where the hits were before all edits, kNowhere for those that came with one.
    void take(const HistoryEdit& edit, std::span<const std::uint32_t> rows) {
        for (std::size_t i = 0; i < rows.size(); ++i) {
            m_taken.push_back({edit.before[i], rows[i]});
        }
    }
    /// The row of the first hit taken that equals `hit`, once; kNowhere if there is none.
    std::uint32_t find(const Hit& hit) {
        for (; m_hashed < m_taken.size(); ++m_hashed) {
            m_byHash[hashOf(m_taken[m_hashed].hit)].push_back(m_hashed);
        }
        const auto bucket = m_byHash.find(hashOf(hit));
        if (bucket == m_byHash.end()) {
            return kNowhere;
        }
        std::deque<std::size_t>& places = bucket->second;
        const auto place = std::find_if(places.begin(), places.end(),
                                        [&](std::size_t candidate) { return m_taken[candidate].hit == hit; });
        if (place == places.end()) {
            return kNowhere;
        }
        const std::uint32_t row = m_taken[*place].row;
        places.erase(place);
        return row;
    }

private:
    struct Taken {
        Hit hit;
        std::uint32_t row = kNowhere;
    };
    std::vector<Taken> m_taken;
    std::size_t m_hashed = 0;  ///< of m_taken; hashed when first looked for, which removals never do
    std::unordered_map<std::size_t, std::deque<std::size_t>> m_byHash;
};

Hit withDentOf(Hit hit, const Hit& other) {
    hit.enabled = other.enabled;
    hit.constants = other.constants;
    hit.form = other.form;
    hit.group = other.group;
    return hit;
}

/// Whether `after` is `before`, edited: an edit leaves alone when a hit was made, and how hard. A target that
/// gets another mesh is another one.
bool isSameEdited(const Hit& before, const Hit& after) {
    Hit edited = withDentOf(before, after);
    edited.target = after.target;
    edited.point = after.point;
    edited.direction = after.direction;
    edited.flight = after.flight;
    edited.normal = after.normal;
    edited.triangle = after.triangle;
    return edited == after;
}

/// Whether the same hits only stand in another order, which hits of one moment may.
bool isReordered(const HistoryEdit& edit) {
    const bool isInPlace =
        std::equal(edit.before.begin(), edit.before.end(), edit.after.begin(), edit.after.end(),
                   [](const Hit& before, const Hit& after) { return withDentOf(before, after) == after; });
    if (isInPlace) {
        return false;
    }
    TakenHits taken;
    taken.take(edit, std::vector<std::uint32_t>(edit.before.size()));
    return std::all_of(edit.after.begin(), edit.after.end(),
                       [&taken](const Hit& hit) { return taken.find(hit) != kNowhere; });
}

}  // namespace

bool keepsPlaces(const HistoryEdit& edit) {
    if (edit.before.size() == 1 && edit.after.size() == 1) {
        return true;
    }
    return std::equal(edit.before.begin(), edit.before.end(), edit.after.begin(), edit.after.end(),
                      isSameEdited) &&
           !isReordered(edit);
}

HitRows::HitRows(std::size_t sizeBefore, std::span<const HistoryEdit> edits) {
    std::vector<std::uint32_t> was(sizeBefore);  // by row now
    std::iota(was.begin(), was.end(), 0u);
    TakenHits taken;
    for (const HistoryEdit& edit : edits) {
        if (keepsPlaces(edit)) {
            continue;
        }
        const auto begin = was.begin() + static_cast<std::ptrdiff_t>(edit.first);
        const auto end = begin + static_cast<std::ptrdiff_t>(edit.before.size());
        taken.take(edit, {begin, end});
        std::vector<std::uint32_t> after(edit.after.size());
        std::transform(edit.after.begin(), edit.after.end(), after.begin(),
                       [&taken](const Hit& hit) { return taken.find(hit); });
        was.insert(was.erase(begin, end), after.begin(), after.end());
    }
    m_size = was.size();
    m_now.assign(sizeBefore, kNowhere);
    for (std::size_t row = 0; row < was.size(); ++row) {
        if (was[row] != kNowhere) {
            m_now[was[row]] = static_cast<std::uint32_t>(row);
        }
    }
}

std::optional<std::size_t> HitRows::now(std::size_t before) const {
    return m_now[before] == kNowhere ? std::nullopt : std::optional<std::size_t>(m_now[before]);
}

}  // namespace hitscope
