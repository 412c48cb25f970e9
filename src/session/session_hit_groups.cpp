// SPDX-License-Identifier: GPL-3.0-or-later
// Groups of hits.
#include <algorithm>

#include "session/session.h"

namespace hitscope {

namespace {

SessionUndo::Kind stepOf(HitGroupKind kind) {
    switch (kind) {
        case HitGroupKind::Mirror:
            return SessionUndo::Kind::Mirror;
        case HitGroupKind::Scatter:
            return SessionUndo::Kind::Scatter;
        case HitGroupKind::Stroke:
            return SessionUndo::Kind::Stroke;
        case HitGroupKind::None:
        case HitGroupKind::Chosen:
            break;
    }
    return SessionUndo::Kind::Hit;
}

}  // namespace

HitGroup SessionHits::newGroup(HitGroupKind kind) const {
    std::uint32_t last = 0;
    for (const Hit& hit : m_history.hits()) {
        last = hit.group.kind == kind ? std::max(last, hit.group.number) : last;
    }
    return {last + 1, kind};
}

Result<HitGroup> SessionHits::addGroup(HitGroupKind kind, std::span<const Hit> hits) {
    Result<std::vector<Hit>> checked = this->checked(hits);
    if (!checked) {
        return checked.error();
    }
    std::vector<Hit> grouped = std::move(checked).value();
    const HitGroup group = newGroup(kind);
    for (Hit& hit : grouped) {
        hit.group = group;
    }
    append(grouped, stepOf(kind));
    return group;
}

Status SessionHits::extendStroke(const HitGroup& stroke, const Hit& hit) {
    Result<std::vector<Hit>> checked = this->checked({&hit, 1});
    if (!checked) {
        return checked.error();
    }
    std::vector<Hit> grouped = std::move(checked).value();
    grouped.front().group = stroke;
    append(grouped, SessionUndo::Kind::Stroke, SessionUndo::Merge::WithSameKind);
    return Done{};
}

std::vector<std::size_t> SessionHits::of(const HitGroup& group) const {
    std::vector<std::size_t> rows;
    const std::span<const Hit> hits = m_history.hits();
    for (std::size_t row = 0; group && row < hits.size(); ++row) {
        if (hits[row].group == group) {
            rows.push_back(row);
        }
    }
    return rows;
}

void SessionHits::setGroup(std::span<const std::size_t> indices, const HitGroup& group,
                           SessionUndo::Kind kind) {
    const std::vector<std::size_t> rows = m_history.rows(indices);
    std::vector<Hit> hits;
    hits.reserve(rows.size());
    for (const std::size_t row : rows) {
        hits.push_back(m_history.hits()[row]);
        hits.back().group = group;
    }
    // They are in the history, and differ in nothing that could be refused.
    static_cast<void>(replace(rows, hits, kind));
}

void SessionHits::group(std::span<const std::size_t> indices) {
    setGroup(indices, newGroup(HitGroupKind::Chosen), SessionUndo::Kind::Group);
}

void SessionHits::ungroup(std::span<const std::size_t> indices) {
    setGroup(indices, {}, SessionUndo::Kind::Ungroup);
}

}  // namespace hitscope
