// SPDX-License-Identifier: GPL-3.0-or-later
// Which of the session's hits are shown, and changing a single one.
#include <algorithm>
#include <numeric>
#include <utility>

#include "session/session.h"

namespace hitscope {

namespace {

/// Above this, one edit over all between the first and the last hit concerned costs less than one a run.
constexpr std::size_t kMostReplacedRuns = 64;

/// Puts hits[i] at indices[i], which ascend: one edit for each run of neighbours.
std::vector<HistoryEdit> spliceEach(HitHistory& history, std::span<const std::size_t> indices,
                                    std::span<const Hit> hits) {
    std::vector<std::size_t> starts;
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (i == 0 || indices[i] != indices[i - 1] + 1) {
            starts.push_back(i);
        }
    }
    std::vector<HistoryEdit> edits;
    if (starts.size() > kMostReplacedRuns) {
        const std::span<const Hit> all = history.hits();
        std::vector<Hit> after(all.begin() + static_cast<std::ptrdiff_t>(indices.front()),
                               all.begin() + static_cast<std::ptrdiff_t>(indices.back()) + 1);
        for (std::size_t i = 0; i < indices.size(); ++i) {
            after[indices[i] - indices.front()] = hits[i];
        }
        edits.push_back(history.splice(indices.front(), after.size(), after));
        return edits;
    }
    for (std::size_t run = 0; run < starts.size(); ++run) {
        const std::size_t end = run + 1 < starts.size() ? starts[run + 1] : indices.size();
        const std::size_t count = end - starts[run];
        edits.push_back(history.splice(indices[starts[run]], count, hits.subspan(starts[run], count)));
    }
    return edits;
}

}  // namespace

void Session::showHits(std::optional<std::size_t> count) {
    if (count != m_shownHits) {
        m_shownHits = count;
        m_readBack->expectMoves();
        Q_EMIT shownHitsChanged();
        Q_EMIT pictureChanged();
    }
}

std::span<const Hit> Session::shownHits() const {
    return m_history.hits().first(std::min(m_shownHits.value_or(m_history.size()), m_history.size()));
}

Status Session::replaceHits(std::span<const std::size_t> indices, std::span<const Hit> hits,
                            SessionUndo::Kind kind, SessionUndo::Merge merge) {
    std::vector<Hit> checkedHits;
    checkedHits.reserve(hits.size());
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const Result<Hit> checked = checkedHit(hits[i]);
        if (!checked) {
            return checked.error();
        }
        if (indices[i] >= m_history.size() || target(hits[i].target) == nullptr) {
            return Error{"The hit is no longer in the history.", "", "Choose another."};
        }
        checkedHits.push_back(checked.value());
    }
    std::vector<HistoryEdit> edits = spliceEach(m_history, indices, checkedHits);
    std::erase_if(edits, [](const HistoryEdit& edit) { return edit.after.empty(); });
    if (!edits.empty()) {
        changeHistory(std::move(edits), {kind, hits.size()}, merge);
    }
    return Done{};
}

void Session::giveConstants(std::span<const std::size_t> indices) {
    std::vector<std::size_t> sorted(indices.begin(), indices.end());
    std::erase_if(sorted, [this](std::size_t index) { return index >= m_history.size(); });
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    std::vector<Hit> hits;
    hits.reserve(sorted.size());
    for (const std::size_t index : sorted) {
        hits.push_back(m_history.hits()[index]);
        hits.back().constants = constantsOf(hits.back());
    }
    // Constants in force are within what a hit may have, so this is not refused.
    static_cast<void>(replaceHits(sorted, hits, SessionUndo::Kind::HitConstants));
}

void Session::giveConstantsToAll() {
    std::vector<std::size_t> all(m_history.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    giveConstants(all);
}

}  // namespace hitscope
