// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/hit_editing.h"

#include <algorithm>
#include <utility>

#include "session/frame_costs.h"

namespace hitscope {

namespace {

constexpr int kNoFrame = 250;  // milliseconds after which an edit no longer waits for one

}  // namespace

HitEditing::HitEditing(Session& session, QObject* parent) : QObject(parent), m_session(session) {
    m_noFrameTimer.setSingleShot(true);
    m_noFrameTimer.setInterval(kNoFrame);
    connect(&m_noFrameTimer, &QTimer::timeout, this, &HitEditing::frameEnded);
    connect(&session.frameCosts(), &FrameCosts::frameEnded, this, &HitEditing::frameEnded);
    connect(&session.hits(), &SessionHits::selectedChanged, this, &HitEditing::followSelected);
    connect(&session.hits(), &SessionHits::changed, this, &HitEditing::follow);
    connect(&session.hits(), &SessionHits::rearranged, this, [this](const HitRows& rows) {
        std::vector<std::size_t> now;
        for (const std::size_t row : m_rows) {
            if (const auto place = rows.now(row)) {
                now.push_back(*place);
            }
        }
        std::sort(now.begin(), now.end());
        m_rows = std::move(now);
        if (!m_isApplying) {
            m_pending = nullptr;  // it was of the history before, as in follow()
        }
        endGesture();
        Q_EMIT rowsChanged();
        Q_EMIT edited();
    });
    connect(&session, &Session::sceneReplaced, this, [this] {
        m_pending = nullptr;
        select({});
    });
}

void HitEditing::select(std::vector<std::size_t> rows) {
    if (rows == m_rows) {
        return;
    }
    endGesture();
    m_rows = std::move(rows);
    Q_EMIT rowsChanged();
    Q_EMIT edited();
}

void HitEditing::followSelected() {
    const std::optional<std::size_t> hit = m_session.hits().selected();
    if (!hit) {
        select({});
    } else if (!std::binary_search(m_rows.begin(), m_rows.end(), *hit)) {
        select({*hit});
    } else {
        Q_EMIT edited();
    }
}

const Hit* HitEditing::current() const {
    const std::optional<std::size_t> hit = m_session.hits().selected();
    return hit && *hit < m_session.hits().history().size() ? &m_session.hits().history().hits()[*hit]
                                                           : nullptr;
}

void HitEditing::follow() {
    if (!m_isApplying) {
        // Undone, say: what goes on from here is something else.
        m_pending = nullptr;
        m_gesture.end();
        m_part = -1;
    }
    Q_EMIT edited();
}

void HitEditing::change(int part, const Edit& edit, SessionUndo::Kind kind) {
    if (part != m_part) {
        endGesture();
        m_part = part;
        m_before.clear();
        for (const std::size_t row : m_rows) {
            m_before.push_back(m_session.hits().history().hits()[row]);
        }
    }
    m_pending = edit;
    m_kind = kind;
    if (!m_awaitsFrame) {
        apply();
    }
}

void HitEditing::apply() {
    const Edit edit = std::exchange(m_pending, nullptr);
    if (!edit || m_rows.empty()) {
        return;
    }
    std::vector<Hit> hits;
    hits.reserve(m_rows.size());
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const bool isKnown = m_part >= 0 && m_before.size() == m_rows.size();
        hits.push_back(isKnown ? m_before[i] : m_session.hits().history().hits()[m_rows[i]]);
        edit(hits.back());
    }
    if (m_rows.back() >= m_session.hits().shown().size()) {
        m_session.hits().show(std::nullopt);  // who edits a hit wants to see it
    }
    m_isApplying = true;
    const std::uint64_t revision = m_session.hits().history().revision();
    const Status replaced = m_session.hits().replace(m_rows, hits, m_kind, m_gesture.change(m_part));
    m_isApplying = false;
    if (!replaced) {
        Q_EMIT refused(replaced.error());
        Q_EMIT edited();
    } else if (revision != m_session.hits().history().revision()) {
        m_awaitsFrame = true;
        m_noFrameTimer.start();
    }
}

void HitEditing::frameEnded() {
    m_noFrameTimer.stop();
    m_awaitsFrame = false;
    apply();
}

void HitEditing::endGesture() {
    if (m_part < 0) {
        return;
    }
    apply();
    m_gesture.end();
    m_part = -1;
    m_session.finishUndoStep();
}

void HitEditing::cancelGesture() {
    m_pending = nullptr;
    if (m_part >= 0 && m_before.size() == m_rows.size()) {
        m_isApplying = true;
        static_cast<void>(m_session.hits().replace(m_rows, m_before, m_kind, m_gesture.change(m_part)));
        m_isApplying = false;
    }
    endGesture();
}

}  // namespace hitscope
