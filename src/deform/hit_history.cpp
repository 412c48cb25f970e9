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

/// Above this, one edit over all between the first and the last hit concerned costs less than one a run.
constexpr std::size_t kMostRuns = 64;

/// Neighbouring rows [first, first + count).
struct Run {
    std::size_t first = 0;
    std::size_t count = 0;
};

std::vector<Run> runsOf(std::span<const std::size_t> sorted) {
    std::vector<Run> runs;
    for (const std::size_t row : sorted) {
        if (runs.empty() || runs.back().first + runs.back().count != row) {
            runs.push_back({row, 0});
        }
        ++runs.back().count;
    }
    return runs;
}

/// The hits [first, last) without those at `sorted`.
std::vector<Hit> hitsBeside(std::span<const Hit> hits, std::size_t first, std::size_t last,
                            std::span<const std::size_t> sorted) {
    std::vector<Hit> others;
    for (std::size_t row = first; row < last; ++row) {
        if (!std::binary_search(sorted.begin(), sorted.end(), row)) {
            others.push_back(hits[row]);
        }
    }
    return others;
}

bool isNothing(const HistoryEdit& edit) {
    return edit.before.empty() && edit.after.empty();
}

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
    if (isNothing(edit)) {
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

HistoryEdit HitHistory::append(std::span<const Hit> hits) {
    return splice(size(), 0, hits);
}

HistoryEdit HitHistory::clear() {
    return splice(0, size(), {});
}

std::vector<std::size_t> HitHistory::rows(std::span<const std::size_t> indices) const {
    std::vector<std::size_t> sorted(indices.begin(), indices.end());
    std::erase_if(sorted, [this](std::size_t index) { return index >= size(); });
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    return sorted;
}

std::vector<HistoryEdit> HitHistory::remove(std::span<const std::size_t> indices) {
    return removeRows(rows(indices));
}

std::vector<HistoryEdit> HitHistory::removeRows(std::span<const std::size_t> sorted) {
    const std::vector<Run> runs = runsOf(sorted);
    if (runs.size() > kMostRuns) {
        const std::size_t first = sorted.front();
        const std::size_t last = sorted.back() + 1;
        return {splice(first, last - first, hitsBeside(hits(), first, last, sorted))};
    }
    std::vector<HistoryEdit> edits;
    std::for_each(runs.rbegin(), runs.rend(),
                  [&](const Run& run) { edits.push_back(splice(run.first, run.count, {})); });
    return edits;
}

std::vector<HistoryEdit> HitHistory::move(std::span<const std::size_t> indices, std::size_t to) {
    const std::vector<std::size_t> sorted = rows(indices);
    if (sorted.empty() || to > size()) {
        return {};
    }
    const bool together = sorted.back() - sorted.front() + 1 == sorted.size();
    if (together && to >= sorted.front() && to <= sorted.back() + 1) {
        return {};  // they stand there
    }
    std::vector<Hit> moved;
    moved.reserve(sorted.size());
    std::transform(sorted.begin(), sorted.end(), std::back_inserter(moved),
                   [this](std::size_t row) { return m_hits[row]; });
    const auto above =
        static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), to) - sorted.begin());
    std::vector<HistoryEdit> edits;
    if (runsOf(sorted).size() > kMostRuns) {
        const std::size_t first = std::min(sorted.front(), to);
        const std::size_t last = std::max(sorted.back() + 1, to);
        std::vector<Hit> after = hitsBeside(hits(), first, last, sorted);
        after.insert(after.begin() + static_cast<std::ptrdiff_t>(to - above - first), moved.begin(),
                     moved.end());
        edits.push_back(splice(first, last - first, after));
    } else {
        edits = removeRows(sorted);
        edits.push_back(splice(to - above, 0, moved));
    }
    std::erase_if(edits, isNothing);
    return edits;
}

std::vector<HistoryEdit> HitHistory::moveUp(std::span<const std::size_t> indices) {
    std::vector<Carry> carried;
    for (const Run& run : runsOf(rows(indices))) {
        if (run.first > 0) {
            carried.push_back({run.first - 1, run.first + run.count - 1});
        }
    }
    return carry(carried);
}

std::vector<HistoryEdit> HitHistory::moveDown(std::span<const std::size_t> indices) {
    std::vector<Carry> carried;
    for (const Run& run : runsOf(rows(indices))) {
        if (run.first + run.count < size()) {
            carried.push_back({run.first + run.count, run.first});
        }
    }
    return carry(carried);
}

/// Each within rows that no other one touches; ascending.
std::vector<HistoryEdit> HitHistory::carry(std::span<const Carry> carried) {
    std::vector<HistoryEdit> edits;
    if (carried.size() <= kMostRuns) {
        for (const Carry& one : carried) {
            const Hit hit = m_hits[one.from];
            edits.push_back(splice(one.from, 1, {}));
            edits.push_back(splice(one.to, 0, {&hit, 1}));
        }
        return edits;
    }
    const std::size_t first = std::min(carried.front().from, carried.front().to);
    const std::size_t last = std::max(carried.back().from, carried.back().to) + 1;
    std::vector<Hit> after(m_hits.begin() + static_cast<std::ptrdiff_t>(first),
                           m_hits.begin() + static_cast<std::ptrdiff_t>(last));
    for (const Carry& one : carried) {
        const auto low = after.begin() + static_cast<std::ptrdiff_t>(std::min(one.from, one.to) - first);
        const auto high = after.begin() + static_cast<std::ptrdiff_t>(std::max(one.from, one.to) - first);
        std::rotate(low, one.from < one.to ? low + 1 : high, high + 1);
    }
    edits.push_back(splice(first, last - first, after));
    std::erase_if(edits, isNothing);
    return edits;
}

std::vector<HistoryEdit> HitHistory::replace(std::span<const std::size_t> rows, std::span<const Hit> hits) {
    const std::vector<Run> runs = runsOf(rows);
    std::vector<HistoryEdit> edits;
    if (runs.size() > kMostRuns) {
        std::vector<Hit> after(m_hits.begin() + static_cast<std::ptrdiff_t>(rows.front()),
                               m_hits.begin() + static_cast<std::ptrdiff_t>(rows.back()) + 1);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            after[rows[i] - rows.front()] = hits[i];
        }
        edits.push_back(splice(rows.front(), after.size(), after));
    } else {
        for (const Run& run : runs) {
            edits.push_back(splice(run.first, run.count, hits.first(run.count)));
            hits = hits.subspan(run.count);
        }
    }
    std::erase_if(edits, isNothing);
    return edits;
}

std::vector<HistoryEdit> HitHistory::setEnabled(std::span<const std::size_t> indices, bool enabled) {
    const std::vector<std::size_t> sorted = rows(indices);
    std::vector<Hit> after;
    after.reserve(sorted.size());
    for (const std::size_t row : sorted) {
        after.push_back(m_hits[row]);
        after.back().enabled = enabled;
    }
    return replace(sorted, after);
}

}  // namespace hitscope
