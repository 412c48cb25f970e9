// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "deform/applied_history.h"

namespace hitscope {

/// A copy of a session's hits on another thread that is kept up to date at the cost of the edits; hits that
/// are not applied to what is shown (SessionHits::applied()) are disabled in it. What brings it there,
/// HistoryFollower::update(), is made on the session's thread; the copy itself is used by one thread at a
/// time.
class HistoryCopy {
public:
    struct Update {
        std::vector<HistoryEdit> edits;
    };
    void apply(const Update& update);
    [[nodiscard]] std::span<const Hit> hits() const { return m_hits; }

private:
    std::vector<Hit> m_hits;
};

/// The session's side of a HistoryCopy.
class HistoryFollower {
public:
    /// What brings copy() up to date; to be applied exactly once, before the copy is used.
    [[nodiscard]] HistoryCopy::Update update(const HitHistory& history, const AppliedHits& applied);
    [[nodiscard]] const std::shared_ptr<HistoryCopy>& copy() const { return m_copy; }
    /// Leaves the copy to who still uses it; the next update() is of a new one.
    void startOver() { m_copy.reset(); }

private:
    std::shared_ptr<HistoryCopy> m_copy;
    AppliedHistory m_applied;
    std::uint64_t m_revision = 0;
};

}  // namespace hitscope
