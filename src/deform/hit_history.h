// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
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
    HistoryEdit clear();

    /// Those of `indices` that are < size(), in ascending order, each once.
    [[nodiscard]] std::vector<std::size_t> rows(std::span<const std::size_t> indices) const;

    // Changes of several hits: one edit for each run of neighbours, so that followers see what changed and
    // not all between; or one edit over everything from the first to the last where there are many runs. The
    // edits are in the order made, and each changes something.

    /// Indices in any order.
    std::vector<HistoryEdit> remove(std::span<const std::size_t> indices);
    /// The hits (indices in any order) come to stand together, in their order, before the hit that is at `to`
    /// now, or at the end: to <= size(), else nothing moves.
    std::vector<HistoryEdit> move(std::span<const std::size_t> indices, std::size_t to);
    /// Each of the hits (indices in any order) goes past the one before it that is not among them, so that
    /// neighbours stay together; those that have none before them stay.
    std::vector<HistoryEdit> moveUp(std::span<const std::size_t> indices);
    std::vector<HistoryEdit> moveDown(std::span<const std::size_t> indices);  ///< likewise, the one after it
    /// Puts hits[i] at rows[i]. `rows` ascend and are < size(), each once; `hits` are as many and have passed
    /// checkedHit().
    std::vector<HistoryEdit> replace(std::span<const std::size_t> rows, std::span<const Hit> hits);
    /// Indices in any order.
    std::vector<HistoryEdit> setEnabled(std::span<const std::size_t> indices, bool enabled);

    /// Makes an undone edit again. The inverse of an edit undoes it. What `edit` says was there before is
    /// there.
    void redo(const HistoryEdit& edit);

private:
    /// The hit at `from` is to be at `to`.
    struct Carry {
        std::size_t from = 0;
        std::size_t to = 0;
    };
    void record(HistoryEdit edit);
    std::vector<HistoryEdit> removeRows(std::span<const std::size_t> sorted);
    std::vector<HistoryEdit> carry(std::span<const Carry> carried);

    std::vector<Hit> m_hits;
    std::uint64_t m_revision = 0;
    std::deque<HistoryEdit> m_journal;  ///< the latest edits, the last of them made revision m_revision
    std::size_t m_journalHits = 0;      ///< in m_journal, before and after together
};

}  // namespace hitscope
