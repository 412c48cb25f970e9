// SPDX-License-Identifier: GPL-3.0-or-later
// The session's hits: every change of the history passes through here.
#include <algorithm>
#include <numeric>
#include <utility>

#include "session/session.h"

namespace hitscope {

namespace {

/// Neighbouring rows [first, first + count).
struct Run {
    std::size_t first = 0;
    std::size_t count = 0;
};

/// Above this, one edit over all between the first and the last hit concerned costs less than one a run.
constexpr std::size_t kMostRuns = 64;

/// `indices` less those not below `size`, in ascending order, each once.
std::vector<std::size_t> inOrder(std::span<const std::size_t> indices, std::size_t size) {
    std::vector<std::size_t> sorted(indices.begin(), indices.end());
    std::erase_if(sorted, [size](std::size_t index) { return index >= size; });
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    return sorted;
}

std::vector<Run> runsOf(std::span<const std::size_t> sorted) {
    std::vector<Run> runs;
    for (const std::size_t index : sorted) {
        if (runs.empty() || runs.back().first + runs.back().count != index) {
            runs.push_back({index, 0});
        }
        ++runs.back().count;
    }
    return runs;
}

std::vector<Hit> hitsAt(std::span<const Hit> hits, std::span<const std::size_t> indices) {
    std::vector<Hit> chosen;
    chosen.reserve(indices.size());
    for (const std::size_t index : indices) {
        chosen.push_back(hits[index]);
    }
    return chosen;
}

/// The hits [first, last) without those at `sorted`.
std::vector<Hit> hitsBeside(std::span<const Hit> hits, std::size_t first, std::size_t last,
                            std::span<const std::size_t> sorted) {
    std::vector<Hit> others;
    for (std::size_t index = first; index < last; ++index) {
        if (!std::binary_search(sorted.begin(), sorted.end(), index)) {
            others.push_back(hits[index]);
        }
    }
    return others;
}

std::vector<HistoryEdit> remove(HitHistory& history, std::span<const std::size_t> sorted) {
    std::vector<HistoryEdit> edits;
    const std::vector<Run> runs = runsOf(sorted);
    if (runs.size() > kMostRuns) {
        const std::size_t first = sorted.front();
        const std::size_t last = sorted.back() + 1;
        edits.push_back(history.splice(first, last - first, hitsBeside(history.hits(), first, last, sorted)));
        return edits;
    }
    std::for_each(runs.rbegin(), runs.rend(),
                  [&](const Run& run) { edits.push_back(history.splice(run.first, run.count, {})); });
    return edits;
}

std::vector<HistoryEdit> move(HitHistory& history, std::span<const std::size_t> sorted, std::size_t to) {
    const std::vector<Hit> moved = hitsAt(history.hits(), sorted);
    const auto above =
        static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), to) - sorted.begin());
    if (runsOf(sorted).size() > kMostRuns) {
        const std::size_t first = std::min(sorted.front(), to);
        const std::size_t last = std::max(sorted.back() + 1, to);
        std::vector<Hit> after = hitsBeside(history.hits(), first, last, sorted);
        after.insert(after.begin() + static_cast<std::ptrdiff_t>(to - above - first), moved.begin(),
                     moved.end());
        return {history.splice(first, last - first, after)};
    }
    std::vector<HistoryEdit> edits = remove(history, sorted);
    edits.push_back(history.splice(to - above, 0, moved));
    return edits;
}

std::size_t countDisabled(std::span<const Hit> hits) {
    return static_cast<std::size_t>(
        std::count_if(hits.begin(), hits.end(), [](const Hit& hit) { return !hit.enabled; }));
}

}  // namespace

Status Session::addHits(std::span<const Hit> hits) {
    std::vector<Hit> checkedHits;
    checkedHits.reserve(hits.size());
    for (const Hit& hit : hits) {
        Result<Hit> checked = checkedHit(hit);
        if (!checked) {
            return checked.error();
        }
        if (target(hit.target) == nullptr) {
            return Error{"The hit is on a target that is not in the scene.", "",
                         "Load the scene it was made in."};
        }
        checkedHits.push_back(checked.value());
    }
    appendHits(checkedHits);
    return Done{};
}

void Session::appendHits(std::span<const Hit> hits) {
    if (hits.empty()) {
        return;
    }
    const int first = static_cast<int>(m_history.size());
    Q_EMIT hitsAboutToBeAppended(first, first + static_cast<int>(hits.size()) - 1);
    const HistoryEdit edit = m_history.append(hits);
    expectMoves({&edit, 1});
    recordUndo(
        {{edit}, m_constants, m_constants, SessionUndo::Merge::Never, {SessionUndo::Kind::Hit, hits.size()}});
    m_disabledHits += countDisabled(hits);
    Q_EMIT hitsAppended();
    showHits(std::nullopt);
    selectTarget(hits.back().target);
    Q_EMIT pictureChanged();
}

void Session::recordUndo(SessionUndo::Change change) {
    m_undo.record(std::move(change));
    Q_EMIT undoChanged();
}

/// The constants in force stay as they are.
void Session::changeHistory(std::vector<HistoryEdit> edits, SessionUndo::Name name,
                            SessionUndo::Merge merge) {
    recordUndo({edits, m_constants, m_constants, merge, name});
    announceEdits(edits);
}

std::vector<HistoryEdit> Session::spliceOut(std::span<const std::size_t> hits) {
    return hits.empty() ? std::vector<HistoryEdit>{} : remove(m_history, hits);
}

void Session::announceEdits(std::span<const HistoryEdit> edits) {
    expectMoves(edits);
    std::size_t first = m_history.size();
    std::size_t last = 0;
    std::size_t sizeBefore = m_history.size();
    bool placesKept = true;
    for (const HistoryEdit& edit : edits) {
        if (edit.before.empty() && edit.after.empty()) {
            continue;
        }
        first = std::min(first, edit.first);
        last = std::max(last, edit.first + edit.after.size());
        sizeBefore = sizeBefore + edit.before.size() - edit.after.size();
        m_disabledHits = m_disabledHits + countDisabled(edit.after) - countDisabled(edit.before);
        placesKept = placesKept && keepsPlaces(edit);
    }
    if (!placesKept) {
        announceRows(HitRows(sizeBefore, edits));
    } else if (first < last) {
        Q_EMIT hitsChanged(static_cast<int>(first), static_cast<int>(last) - 1);
    } else {
        return;
    }
    Q_EMIT historyReset();
    Q_EMIT pictureChanged();
}

void Session::announceRows(const HitRows& rows) {
    const std::optional<std::size_t> selected = m_selectedHit;
    if (selected) {
        m_selectedHit = rows.now(*selected);
    }
    Q_EMIT hitsRearranged(rows);
    if (m_selectedHit != selected) {
        Q_EMIT hitSelected();
    }
}

void Session::undo() {
    if (m_undo.canUndo()) {
        makeAgain(m_undo.undo());
    }
}

void Session::redo() {
    if (m_undo.canRedo()) {
        makeAgain(m_undo.redo());
    }
}

void Session::makeAgain(const SessionUndo::Change& change) {
    for (const HistoryEdit& edit : change.edits) {
        m_history.redo(edit);
    }
    takeConstants(change.constantsAfter);
    for (const LightsEdit& edit : change.lights) {
        restoreLights(edit.after);
    }
    follow(change);
    Q_EMIT undoChanged();
}

void Session::setHitsEnabled(std::span<const std::size_t> indices, bool enabled) {
    std::vector<HistoryEdit> edits;
    std::size_t changed = 0;
    for (const Run& run : runsOf(inOrder(indices, m_history.size()))) {
        const std::span<const Hit> before = m_history.hits().subspan(run.first, run.count);
        std::vector<Hit> after(before.begin(), before.end());
        for (Hit& hit : after) {
            changed += hit.enabled != enabled ? 1 : 0;
            hit.enabled = enabled;
        }
        edits.push_back(m_history.splice(run.first, run.count, after));
    }
    changeHistory(std::move(edits),
                  {enabled ? SessionUndo::Kind::Enable : SessionUndo::Kind::Disable, changed});
}

void Session::enableAllHits() {
    std::vector<std::size_t> all(m_history.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    setHitsEnabled(all, true);
}

void Session::moveHits(std::span<const std::size_t> indices, std::size_t to) {
    const std::vector<std::size_t> sorted = inOrder(indices, m_history.size());
    if (sorted.empty() || to > m_history.size()) {
        return;
    }
    const bool together = sorted.back() - sorted.front() + 1 == sorted.size();
    if (together && to >= sorted.front() && to <= sorted.back() + 1) {
        return;  // they stand there
    }
    changeHistory(move(m_history, sorted, to), {SessionUndo::Kind::Move, sorted.size()});
}

void Session::removeHits(std::span<const std::size_t> indices) {
    const std::vector<std::size_t> sorted = inOrder(indices, m_history.size());
    if (!sorted.empty()) {
        changeHistory(remove(m_history, sorted), {SessionUndo::Kind::Remove, sorted.size()});
    }
}

void Session::removeHit(std::size_t index) {
    removeHits({&index, 1});
}

void Session::clearHits() {
    const std::size_t hits = m_history.size();
    if (hits > 0) {
        changeHistory({m_history.clear()}, {SessionUndo::Kind::Clear, hits});
    }
}

void Session::selectHit(std::optional<std::size_t> index) {
    if (index && *index >= m_history.size()) {
        index.reset();
    }
    if (index != m_selectedHit) {
        m_selectedHit = index;
        Q_EMIT hitSelected();
        Q_EMIT pictureChanged();
    }
}

bool Session::isApplied(std::size_t index) const {
    return index < m_history.size() && m_history.hits()[index].enabled && appliedHits().contains(index);
}

}  // namespace hitscope
