// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "deform/hit.h"

namespace hitscope {

/// One change of a hit history: its hits [first, first + before.size()) became `after`. Every change is of
/// this kind, so whoever follows a history needs to understand no other, and its inverse is the same with
/// before and after exchanged.
struct HistoryEdit {
    std::size_t first = 0;
    std::vector<Hit> before;
    std::vector<Hit> after;
};

/// The ordered hits of a session: the truth that every target's state follows from.
///
/// `revision` counts the edits ever made. Who has followed the history up to revision r brings itself up to
/// date with editsSince(r), at the cost of what changed.
class HitHistory {
public:
    [[nodiscard]] std::span<const Hit> hits() const { return m_hits; }
    [[nodiscard]] std::size_t size() const { return m_hits.size(); }
    /// The enabled hits on one target, in order.
    [[nodiscard]] std::vector<Hit> hitsOn(TargetId target) const;

    [[nodiscard]] std::uint64_t revision() const { return m_revision; }
    /// The edits made since `revision` (<= revision()), oldest first; nothing when some of them are no longer
    /// kept, so that the follower starts over.
    [[nodiscard]] std::optional<std::vector<HistoryEdit>> editsSince(std::uint64_t revision) const;

    /// Hits [first, first + count) become `after`; all others below go through it. first + count <= size();
    /// `after` has passed checkedHit(). Returns the edit made, less what was the same on both sides; its
    /// before and after are empty when nothing changed.
    HistoryEdit splice(std::size_t first, std::size_t count, std::span<const Hit> after);

    HistoryEdit append(std::span<const Hit> hits);  ///< they have passed checkedHit()
    HistoryEdit append(const Hit& hit) { return append({&hit, 1}); }
    HistoryEdit remove(std::size_t index);      ///< index < size()
    HistoryEdit removeTarget(TargetId target);  ///< every hit on it
    /// Takes the hit out and puts it in so that it comes to stand at `to`. from, to < size(). Two edits, so
    /// that followers see one hit move and not all between.
    std::vector<HistoryEdit> move(std::size_t from, std::size_t to);
    HistoryEdit setEnabled(std::size_t index, bool enabled);  ///< index < size()
    /// Each gets what `constants` says for it; that is within hitParameters().
    HistoryEdit setConstantsOfAll(const std::function<DeformationConstants(const Hit&)>& constants);
    HistoryEdit clear();

    /// Makes `edit` undone: what it brought becomes what it took. It was the last edit, or all after it have
    /// been undone.
    void undo(const HistoryEdit& edit);
    /// Makes an undone edit again.
    void redo(const HistoryEdit& edit);

private:
    void record(HistoryEdit edit);

    std::vector<Hit> m_hits;
    std::uint64_t m_revision = 0;
    std::deque<HistoryEdit> m_journal;  ///< the latest edits, the last of them made revision m_revision
    std::size_t m_journalHits = 0;      ///< in m_journal, before and after together
};

}  // namespace hitscope
