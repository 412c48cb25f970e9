// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session_hits.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "session/flight_mode.h"
#include "session/session.h"
#include "session/usual_dent.h"

namespace hitscope {

namespace {

std::size_t countDisabled(std::span<const Hit> hits) {
    return static_cast<std::size_t>(
        std::count_if(hits.begin(), hits.end(), [](const Hit& hit) { return !hit.enabled; }));
}

SessionUndo::Name nameOf(SessionUndo::Kind kind, std::span<const std::size_t> rows) {
    return {kind, rows.size(), rows.size() == 1 ? rows.front() + 1 : 0};
}

}  // namespace

SessionHits::SessionHits(Session& session) : m_session(session) {}

Status SessionHits::add(std::span<const Hit> hits) {
    const Result<std::vector<Hit>> checked = this->checked(hits);
    if (checked) {
        append(checked.value());
    }
    return checked ? Status(Done{}) : Status(checked.error());
}

Result<std::vector<Hit>> SessionHits::checked(std::span<const Hit> hits) const {
    std::vector<Hit> checkedHits;
    checkedHits.reserve(hits.size());
    for (const Hit& hit : hits) {
        Result<Hit> checked = checkedHit(hit);
        if (!checked) {
            return checked.error();
        }
        if (m_session.m_targets.find(hit.target) == nullptr) {
            return Error{"The hit is on a target that is not in the scene.", "",
                         "Load the scene it was made in."};
        }
        checkedHits.push_back(checked.value());
    }
    return checkedHits;
}

void SessionHits::append(std::span<const Hit> hits, SessionUndo::Kind kind, SessionUndo::Merge merge,
                         std::vector<TargetPlace> places) {
    if (hits.empty()) {
        return;
    }
    const HistoryEdit edit = appendQuietly(hits);
    const std::size_t number = hits.size() == 1 ? m_history.size() : 0;
    m_session.record(
        {.name = {kind, hits.size(), number}, .merge = merge, .edits = {edit}, .places = std::move(places)});
    m_disabled += countDisabled(hits);
    Q_EMIT appended();
    show(std::nullopt);
    m_session.m_targets.select(hits.back().target);
    Q_EMIT m_session.pictureChanged();
}

void SessionHits::bringBack(std::span<const Hit> hits) {
    if (!hits.empty()) {
        appendQuietly(hits);
        m_disabled += countDisabled(hits);
        Q_EMIT appended();
        Q_EMIT m_session.pictureChanged();
    }
}

HistoryEdit SessionHits::putIn(std::span<const Hit> hits) {
    return m_history.append(hits);
}

/// All that comes before appended().
HistoryEdit SessionHits::appendQuietly(std::span<const Hit> hits) {
    const int first = static_cast<int>(m_history.size());
    Q_EMIT aboutToBeAppended(first, first + static_cast<int>(hits.size()) - 1);
    HistoryEdit edit = putIn(hits);
    m_session.expectMoves({&edit, 1});
    return edit;
}

void SessionHits::record(std::vector<HistoryEdit> edits, SessionUndo::Name name, SessionUndo::Merge merge) {
    m_session.record({name, merge, edits});
    announce(edits);
}

void SessionHits::makeAgain(std::span<const HistoryEdit> edits) {
    for (const HistoryEdit& edit : edits) {
        m_history.redo(edit);
    }
}

void SessionHits::forgetAll() {
    m_history.clear();
    m_selected.reset();
    m_shown.reset();
    m_disabled = 0;
}

std::vector<std::size_t> SessionHits::on(std::span<const TargetId> targets) const {
    std::vector<std::size_t> found;
    const std::span<const Hit> hits = m_history.hits();
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (std::find(targets.begin(), targets.end(), hits[i].target) != targets.end()) {
            found.push_back(i);
        }
    }
    return found;
}

std::vector<HistoryEdit> SessionHits::takeOut(std::span<const std::size_t> hits) {
    return m_history.remove(hits);
}

void SessionHits::announce(std::span<const HistoryEdit> edits) {
    m_session.expectMoves(edits);
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
        m_disabled = m_disabled + countDisabled(edit.after) - countDisabled(edit.before);
        placesKept = placesKept && keepsPlaces(edit);
    }
    if (!placesKept) {
        announceRows(HitRows(sizeBefore, edits));
    } else if (first < last) {
        Q_EMIT changed(static_cast<int>(first), static_cast<int>(last) - 1);
    } else {
        return;
    }
    Q_EMIT reset();
    Q_EMIT m_session.pictureChanged();
}

void SessionHits::announceRows(const HitRows& rows) {
    const std::optional<std::size_t> selected = m_selected;
    if (selected) {
        m_selected = rows.now(*selected);
    }
    Q_EMIT rearranged(rows);
    if (m_selected != selected) {
        Q_EMIT selectedChanged();
    }
}

void SessionHits::setEnabled(std::span<const std::size_t> indices, bool enabled) {
    const std::vector<std::size_t> rows = m_history.rows(indices);
    std::vector<std::size_t> changed;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(changed),
                 [this, enabled](std::size_t row) { return m_history.hits()[row].enabled != enabled; });
    record(m_history.setEnabled(rows, enabled),
           nameOf(enabled ? SessionUndo::Kind::Enable : SessionUndo::Kind::Disable, changed));
}

void SessionHits::enableAll() {
    std::vector<std::size_t> all(m_history.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    setEnabled(all, true);
}

void SessionHits::move(std::span<const std::size_t> indices, std::size_t to) {
    const std::vector<std::size_t> rows = m_history.rows(indices);
    if (to > m_history.size()) {
        return;
    }
    if (std::vector<HistoryEdit> edits = m_history.move(rows, to); !edits.empty()) {
        record(std::move(edits), nameOf(SessionUndo::Kind::Move, rows));
    }
}

void SessionHits::moveUp(std::span<const std::size_t> indices) {
    if (std::vector<HistoryEdit> edits = m_history.moveUp(indices); !edits.empty()) {
        record(std::move(edits), nameOf(SessionUndo::Kind::Move, m_history.rows(indices)));
    }
}

void SessionHits::moveDown(std::span<const std::size_t> indices) {
    if (std::vector<HistoryEdit> edits = m_history.moveDown(indices); !edits.empty()) {
        record(std::move(edits), nameOf(SessionUndo::Kind::Move, m_history.rows(indices)));
    }
}

void SessionHits::remove(std::span<const std::size_t> indices) {
    const std::vector<std::size_t> rows = m_history.rows(indices);
    if (!rows.empty()) {
        record(m_history.remove(rows), nameOf(SessionUndo::Kind::Remove, rows));
    }
}

void SessionHits::clear() {
    const std::size_t hits = m_history.size();
    if (hits > 0) {
        record({m_history.clear()}, {SessionUndo::Kind::Clear, hits});
    }
}

void SessionHits::select(std::optional<std::size_t> index) {
    if (index && *index >= m_history.size()) {
        index.reset();
    }
    if (index != m_selected) {
        m_selected = index;
        Q_EMIT selectedChanged();
        Q_EMIT m_session.pictureChanged();
    }
}

bool SessionHits::isApplied(std::size_t index) const {
    return index < m_history.size() && m_history.hits()[index].enabled && applied().contains(index);
}

void SessionHits::show(std::optional<std::size_t> count) {
    if (count != m_shown) {
        m_shown = count;
        m_session.m_readBack->expectMoves();
        Q_EMIT shownChanged();
        Q_EMIT m_session.pictureChanged();
    }
}

std::span<const Hit> SessionHits::shown() const {
    return m_history.hits().first(std::min(m_shown.value_or(m_history.size()), m_history.size()));
}

Status SessionHits::replace(std::span<const std::size_t> indices, std::span<const Hit> hits,
                            SessionUndo::Kind kind, SessionUndo::Merge merge) {
    std::vector<Hit> checkedHits;
    checkedHits.reserve(hits.size());
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const Result<Hit> checked = checkedHit(hits[i]);
        if (!checked) {
            return checked.error();
        }
        if (indices[i] >= m_history.size() || m_session.m_targets.find(hits[i].target) == nullptr) {
            return Error{"The hit is no longer in the history.", "", "Choose another."};
        }
        checkedHits.push_back(checked.value());
    }
    std::vector<HistoryEdit> edits = m_history.replace(indices, checkedHits);
    if (!edits.empty()) {
        record(std::move(edits), nameOf(kind, indices), merge);
    }
    return Done{};
}

void SessionHits::giveConstants(std::span<const std::size_t> indices) {
    const std::vector<std::size_t> rows = m_history.rows(indices);
    std::vector<Hit> hits;
    hits.reserve(rows.size());
    for (const std::size_t index : rows) {
        hits.push_back(m_history.hits()[index]);
        hits.back().constants = usualConstants(m_session, hits.back());
        hits.back().form = usualForm(m_session, hits.back());
    }
    // Constants in force are within what a hit may have, so this is not refused.
    static_cast<void>(replace(rows, hits, SessionUndo::Kind::HitConstants));
}

void SessionHits::giveConstantsToAll() {
    std::vector<std::size_t> all(m_history.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    giveConstants(all);
}

AppliedHits SessionHits::applied() const {
    return {m_shown.value_or(AppliedHits::kAll), m_session.m_readBack->capacity().dropped};
}

}  // namespace hitscope
