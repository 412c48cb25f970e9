// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/applied_history.h"

#include <algorithm>
#include <iterator>

namespace hitscope {

namespace {

std::vector<Hit> masked(std::span<const Hit> hits, std::size_t first, const AppliedHits& applied) {
    std::vector<Hit> some(hits.begin(), hits.end());
    for (std::size_t i = 0; i < some.size(); ++i) {
        some[i].enabled = some[i].enabled && applied.contains(first + i);
    }
    return some;
}

}  // namespace

bool AppliedHits::contains(std::size_t index) const {
    return index < shown && !std::binary_search(dropped.begin(), dropped.end(), index);
}

HistoryEdit AppliedHistory::startOver(std::span<const Hit> history, const AppliedHits& wanted) {
    m_shown = wanted.shown;
    m_dropped.assign(wanted.dropped.begin(), wanted.dropped.end());
    return {0, {}, masked(history, 0, applied())};
}

/// Where rows move, what is applied moves along; hits that come among the first are shown.
HistoryEdit AppliedHistory::follow(const HistoryEdit& edit) {
    const std::size_t end = edit.first + edit.before.size();
    HistoryEdit made{edit.first, masked(edit.before, edit.first, applied()), {}};
    if (m_shown != AppliedHits::kAll && edit.first < m_shown) {
        m_shown = m_shown - std::min(edit.before.size(), m_shown - edit.first) + edit.after.size();
    }
    const auto gone = std::lower_bound(m_dropped.begin(), m_dropped.end(), edit.first);
    const auto behind = m_dropped.erase(gone, std::lower_bound(gone, m_dropped.end(), end));
    std::for_each(behind, m_dropped.end(),
                  [&edit](std::size_t& row) { row = row - edit.before.size() + edit.after.size(); });
    made.after = masked(edit.after, edit.first, applied());
    return made;
}

/// Ascending.
std::vector<std::size_t> AppliedHistory::rowsToChange(std::size_t size, const AppliedHits& wanted) const {
    const std::size_t low = std::min({size, m_shown, wanted.shown});
    const std::size_t high = std::min(size, std::max(m_shown, wanted.shown));
    const auto below = [low](std::span<const std::size_t> rows) {
        return rows.first(
            static_cast<std::size_t>(std::lower_bound(rows.begin(), rows.end(), low) - rows.begin()));
    };
    const std::span<const std::size_t> before = below(m_dropped);
    const std::span<const std::size_t> after = below(wanted.dropped);
    std::vector<std::size_t> rows;
    std::set_symmetric_difference(before.begin(), before.end(), after.begin(), after.end(),
                                  std::back_inserter(rows));
    for (std::size_t row = low; row < high; ++row) {
        if (applied().contains(row) != wanted.contains(row)) {
            rows.push_back(row);
        }
    }
    return rows;
}

std::vector<HistoryEdit> AppliedHistory::follow(std::span<const HistoryEdit> edits,
                                                std::span<const Hit> history, const AppliedHits& wanted) {
    std::vector<HistoryEdit> made;
    for (const HistoryEdit& edit : edits) {
        made.push_back(follow(edit));
    }
    for (const std::size_t row : rowsToChange(history.size(), wanted)) {
        if (!history[row].enabled) {
            continue;
        }
        if (made.size() <= edits.size() || made.back().first + made.back().before.size() != row) {
            made.push_back({row, {}, {}});
        }
        HistoryEdit& edit = made.back();
        edit.before.push_back(history[row]);
        edit.before.back().enabled = applied().contains(row);
        edit.after.push_back(history[row]);
        edit.after.back().enabled = wanted.contains(row);
    }
    m_shown = wanted.shown;
    m_dropped.assign(wanted.dropped.begin(), wanted.dropped.end());
    return made;
}

}  // namespace hitscope
