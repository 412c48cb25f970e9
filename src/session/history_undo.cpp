// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/history_undo.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace hitscope {

namespace {

/// Makes `earlier` do what it and then `later` do, where both replace the same hits; dragging a slider makes
/// hundreds of such.
bool absorb(HistoryEdit& earlier, HistoryEdit& later) {
    if (earlier.first != later.first || earlier.after.size() != later.before.size()) {
        return false;
    }
    earlier.after = std::move(later.after);
    return true;
}

}  // namespace

void HistoryUndo::record(Change change) {
    std::erase_if(change.edits,
                  [](const HistoryEdit& edit) { return edit.before.empty() && edit.after.empty(); });
    if (change.edits.empty()) {
        return;
    }
    m_redo.clear();
    if (change.merge == Merge::WithSameKind && canUndo() && m_undo.back().merge == change.merge) {
        Change& last = m_undo.back();
        for (HistoryEdit& edit : change.edits) {
            if (!absorb(last.edits.back(), edit)) {
                last.edits.push_back(std::move(edit));
            }
        }
        last.constantsAfter = change.constantsAfter;
        return;
    }
    m_undo.push_back(std::move(change));
}

DeformationConstants HistoryUndo::undo(HitHistory& history) {
    Change change = std::move(m_undo.back());
    m_undo.pop_back();
    std::for_each(change.edits.rbegin(), change.edits.rend(),
                  [&history](const HistoryEdit& edit) { history.undo(edit); });
    // Undone and made again, it is finished: a later change is a step of its own.
    change.merge = Merge::Never;
    const DeformationConstants constants = change.constantsBefore;
    m_redo.push_back(std::move(change));
    return constants;
}

DeformationConstants HistoryUndo::redo(HitHistory& history) {
    Change change = std::move(m_redo.back());
    m_redo.pop_back();
    for (const HistoryEdit& edit : change.edits) {
        history.redo(edit);
    }
    const DeformationConstants constants = change.constantsAfter;
    m_undo.push_back(std::move(change));
    return constants;
}

void HistoryUndo::clear() {
    m_undo.clear();
    m_redo.clear();
}

}  // namespace hitscope
