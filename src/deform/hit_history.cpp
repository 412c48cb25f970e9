// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/hit_history.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace hitscope {

namespace {

// A follower looks once a frame; these are frames' worth of edits, and bound what the journal costs.
constexpr std::size_t kJournalEdits = 1024;
constexpr std::size_t kJournalHits = 4096;

}  // namespace

std::vector<Hit> HitHistory::hitsOn(TargetId target) const {
    std::vector<Hit> hits;
    std::copy_if(m_hits.begin(), m_hits.end(), std::back_inserter(hits),
                 [target](const Hit& hit) { return hit.enabled && hit.target == target; });
    return hits;
}

std::optional<std::vector<HistoryEdit>> HitHistory::editsSince(std::uint64_t revision) const {
    const std::uint64_t missing = m_revision - revision;
    if (missing > m_journal.size()) {
        return std::nullopt;
    }
    return std::vector<HistoryEdit>(m_journal.end() - static_cast<std::ptrdiff_t>(missing), m_journal.end());
}

/// The last edit is kept however large it is: whoever follows frame by frame must not start over for it.
void HitHistory::record(HistoryEdit edit) {
    m_journalHits += edit.before.size() + edit.after.size();
    m_journal.push_back(std::move(edit));
    ++m_revision;
    while (m_journal.size() > 1 && (m_journal.size() > kJournalEdits || m_journalHits > kJournalHits)) {
        m_journalHits -= m_journal.front().before.size() + m_journal.front().after.size();
        m_journal.pop_front();
    }
}

HistoryEdit HitHistory::splice(std::size_t first, std::size_t count, std::span<const Hit> after) {
    std::span<const Hit> before = hits().subspan(first, count);
    while (!before.empty() && !after.empty() && before.front() == after.front()) {
        before = before.subspan(1);
        after = after.subspan(1);
        ++first;
    }
    while (!before.empty() && !after.empty() && before.back() == after.back()) {
        before = before.first(before.size() - 1);
        after = after.first(after.size() - 1);
    }
    HistoryEdit edit{first, {before.begin(), before.end()}, {after.begin(), after.end()}};
    redo(edit);
    return edit;
}

void HitHistory::redo(const HistoryEdit& edit) {
    if (edit.before.empty() && edit.after.empty()) {
        return;
    }
    const auto begin = m_hits.begin() + static_cast<std::ptrdiff_t>(edit.first);
    const auto kept = static_cast<std::ptrdiff_t>(std::min(edit.before.size(), edit.after.size()));
    std::copy_n(edit.after.begin(), kept, begin);
    m_hits.erase(begin + kept, begin + static_cast<std::ptrdiff_t>(edit.before.size()));
    m_hits.insert(m_hits.begin() + static_cast<std::ptrdiff_t>(edit.first) + kept, edit.after.begin() + kept,
                  edit.after.end());
    record(edit);
}

void HitHistory::undo(const HistoryEdit& edit) {
    redo({edit.first, edit.after, edit.before});
}

HistoryEdit HitHistory::append(std::span<const Hit> hits) {
    return splice(size(), 0, hits);
}

HistoryEdit HitHistory::remove(std::size_t index) {
    return splice(index, 1, {});
}

HistoryEdit HitHistory::removeTarget(TargetId target) {
    std::vector<Hit> kept = m_hits;
    std::erase_if(kept, [target](const Hit& hit) { return hit.target == target; });
    return splice(0, size(), kept);
}

std::vector<HistoryEdit> HitHistory::move(std::size_t from, std::size_t to) {
    if (from == to) {
        return {};
    }
    const Hit moved = m_hits[from];
    std::vector<HistoryEdit> edits;
    edits.push_back(remove(from));
    edits.push_back(splice(to, 0, {&moved, 1}));
    return edits;
}

HistoryEdit HitHistory::setEnabled(std::size_t index, bool enabled) {
    Hit hit = m_hits[index];
    hit.enabled = enabled;
    return splice(index, 1, {&hit, 1});
}

HistoryEdit HitHistory::setConstantsOfAll(const std::function<DeformationConstants(const Hit&)>& constants) {
    std::vector<Hit> changed = m_hits;
    for (Hit& hit : changed) {
        hit.constants = withoutTiny(constants(hit));
    }
    return splice(0, size(), changed);
}

HistoryEdit HitHistory::clear() {
    return splice(0, size(), {});
}

}  // namespace hitscope
