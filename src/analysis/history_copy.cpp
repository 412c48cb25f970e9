// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/history_copy.h"

#include <optional>
#include <utility>

namespace hitscope {

void HistoryCopy::apply(const Update& update) {
    for (const HistoryEdit& edit : update.edits) {
        const auto first = m_hits.begin() + static_cast<std::ptrdiff_t>(edit.first);
        const auto next = m_hits.erase(first, first + static_cast<std::ptrdiff_t>(edit.before.size()));
        m_hits.insert(next, edit.after.begin(), edit.after.end());
    }
}

HistoryCopy::Update HistoryFollower::update(const HitHistory& history, const AppliedHits& applied) {
    std::optional<std::vector<HistoryEdit>> edits;
    if (m_copy) {
        edits = history.editsSince(m_revision);
    }
    m_revision = history.revision();
    if (edits) {
        return {m_applied.follow(*edits, history.hits(), applied)};
    }
    m_copy = std::make_shared<HistoryCopy>();
    return {{m_applied.startOver(history.hits(), applied)}};
}

}  // namespace hitscope
