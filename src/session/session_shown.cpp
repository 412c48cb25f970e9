// SPDX-License-Identifier: GPL-3.0-or-later
// Which of the session's hits are shown, and changing a single one.
#include <algorithm>

#include "session/session.h"

namespace hitscope {

void Session::showHits(std::optional<std::size_t> count) {
    if (count != m_shownHits) {
        m_shownHits = count;
        Q_EMIT shownHitsChanged();
        Q_EMIT pictureChanged();
    }
}

std::span<const Hit> Session::shownHits() const {
    return m_history.hits().first(std::min(m_shownHits.value_or(m_history.size()), m_history.size()));
}

Status Session::replaceHit(std::size_t index, const Hit& hit) {
    const Result<Hit> checked = checkedHit(hit);
    if (!checked) {
        return checked.error();
    }
    if (index >= m_history.size() || target(hit.target) == nullptr) {
        return Error{"The hit is no longer in the history.", "", "Choose another."};
    }
    const HistoryEdit edit = m_history.splice(index, 1, {&checked.value(), 1});
    if (!edit.after.empty()) {
        changeHistory({edit}, {SessionUndo::Kind::EditHit, 1});
    }
    return Done{};
}

}  // namespace hitscope
