// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/zero_array.h"
#include "deform/history_effects.h"
#include "session/session.h"

namespace hitscope {

/// What each hit of a session did, and how many hits moved each vertex, by the reference deformation, which
/// all pipelines agree with. Of the hits that made what is shown (SessionHits::isApplied()).
///
/// Worked out on a thread of its own, at the cost of what the edits of the history reach; results come
/// through the event loop, a moment after the edits. Memory: what hits reach, 30 bytes a vertex at most,
/// and about 100 bytes a hit.
class HitEffects : public QObject {
    Q_OBJECT
public:
    /// `session` outlives this.
    explicit HitEffects(Session& session, QObject* parent = nullptr);
    ~HitEffects() override;

    /// Of the hit in this row (< the history's size). Nothing: not known yet, or the hit is not applied.
    [[nodiscard]] std::optional<HitEffect> effect(std::size_t row) const;
    /// How many hits moved each vertex of a target, by file vertex; empty: none moved any, as far as known.
    [[nodiscard]] std::span<const std::uint32_t> counts(TargetId target) const;
    /// Everything is known, of the hits as they are applied.
    [[nodiscard]] bool isUpToDate() const { return isAnswered() && !m_hasToFollow; }
    /// Waits until it is; for tests and for files.
    void finish();

    /// Finds the vertices that a hit moved. verticesFound() follows; a later request replaces one whose
    /// answer has not been given, even where it is known already.
    void findVertices(std::size_t row);

Q_SIGNALS:
    /// Of hits in the rows [first, last].
    void effectsChanged(int first, int last);
    /// Of these file vertices; none are named: of any.
    void countsChanged(hitscope::TargetId target, const std::vector<std::uint32_t>& vertices);
    /// File vertices of `target`, ascending: those that the hit moved which findVertices() asked about. Not
    /// emitted where the history has changed meanwhile.
    void verticesFound(hitscope::TargetId target, const std::vector<std::uint32_t>& vertices);

private:
    struct Worker;
    /// How an edit that the worker has been given moved the rows.
    struct Shift {
        std::uint64_t number = 0;
        std::size_t first = 0;
        std::size_t before = 0;
        std::size_t after = 0;
    };
    void startOver();
    void follow();
    void followApplied();
    [[nodiscard]] bool isAnswered() const { return m_followed == m_asked; }
    void submit(std::vector<HistoryEdit> edits, const HistoryEffects::Shapes& shapes);
    void followShape(TargetId target);
    void take();
    void takeRows(std::vector<HistoryEffects::Changes::Row>& rows);
    void takeCounts(const HistoryEffects::Changes::Counts& counts);

    Session& m_session;
    std::shared_ptr<Worker> m_worker;
    AppliedHistory m_applied;       ///< as the worker has been given it
    std::uint64_t m_revision = 0;   ///< of the history, likewise
    bool m_hasToFollow = false;     ///< other hits are applied than the worker has been told
    std::uint64_t m_asked = 0;      ///< number of the last task given
    std::uint64_t m_followed = 0;   ///< and of the last whose results are here
    std::uint64_t m_questions = 0;  ///< asked about the vertices of a hit
    std::deque<Shift> m_shifts;     ///< of the tasks between
    std::vector<std::optional<HitEffect>> m_effects;  ///< one a hit
    std::map<TargetId, ZeroArray<std::uint32_t>> m_counts;
};

}  // namespace hitscope
