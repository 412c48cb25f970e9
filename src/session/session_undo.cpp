// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session_undo.h"

#include <algorithm>
#include <utility>

namespace hitscope {

namespace {

/// Makes `earlier` do what it and then `later` do, where both replace the same hits; dragging a slider makes
/// hundreds of such.
bool absorbEdit(HistoryEdit& earlier, HistoryEdit& later) {
    if (earlier.first != later.first || earlier.after.size() != later.before.size()) {
        return false;
    }
    earlier.after = std::move(later.after);
    return true;
}

/// Whether each of `later` changes further what the same one of `earlier` changed, and adds or removes
/// nothing.
bool followOn(const std::vector<TargetEdit>& earlier, const std::vector<TargetEdit>& later) {
    return std::equal(earlier.begin(), earlier.end(), later.begin(), later.end(),
                      [](const TargetEdit& one, const TargetEdit& next) {
                          return one.before && one.after && next.before && next.after &&
                                 one.after->id == next.before->id;
                      });
}

/// Likewise where each of `later` changes further what the same one of `earlier` changed, as when several
/// hits are edited at once.
bool absorbEach(std::vector<HistoryEdit>& earlier, std::vector<HistoryEdit>& later) {
    const auto isSame = [](const HistoryEdit& one, const HistoryEdit& next) {
        return one.first == next.first && one.before.size() == one.after.size() &&
               one.after.size() == next.before.size() && next.before.size() == next.after.size();
    };
    if (!std::equal(earlier.begin(), earlier.end(), later.begin(), later.end(), isSame)) {
        return false;
    }
    for (std::size_t i = 0; i < later.size(); ++i) {
        earlier[i].after = std::move(later[i].after);
    }
    return true;
}

template <typename Value>
bool isNothing(const std::optional<SettingEdit<Value>>& edit) {
    return !edit || edit->before == edit->after;
}

template <typename Value>
std::optional<SettingEdit<Value>> inverse(const std::optional<SettingEdit<Value>>& edit) {
    return edit ? std::optional(SettingEdit<Value>{edit->after, edit->before}) : std::nullopt;
}

/// Makes `earlier` do what it and then `later` do.
template <typename Value>
void absorbSetting(std::optional<SettingEdit<Value>>& earlier, std::optional<SettingEdit<Value>>& later) {
    if (earlier && later) {
        earlier->after = std::move(later->after);
    } else if (later) {
        earlier = std::move(later);
    }
}

bool comesToNothing(const SessionUndo::Change& change) {
    const auto same = [](const HistoryEdit& edit) { return edit.before == edit.after; };
    return change.targets.empty() && std::all_of(change.edits.begin(), change.edits.end(), same) &&
           isNothing(change.constants) && isNothing(change.lights);
}

SessionUndo::Change inverse(const SessionUndo::Change& change) {
    SessionUndo::Change undone;
    undone.name = change.name;
    std::for_each(change.edits.rbegin(), change.edits.rend(), [&undone](const HistoryEdit& edit) {
        undone.edits.push_back({edit.first, edit.after, edit.before});
    });
    std::for_each(change.targets.rbegin(), change.targets.rend(), [&undone](const TargetEdit& edit) {
        undone.targets.push_back({edit.index, edit.after, edit.before});
    });
    undone.constants = inverse(change.constants);
    undone.lights = inverse(change.lights);
    return undone;
}

}  // namespace

bool SessionUndo::absorb(Change& change) {
    if (change.merge != Merge::WithSameKind || !canUndo() || m_undo.back().finished) {
        return false;
    }
    Change& last = m_undo.back().change;
    if (last.name.kind != change.name.kind || !followOn(last.targets, change.targets)) {
        return false;
    }
    if (!absorbEach(last.edits, change.edits)) {
        for (HistoryEdit& edit : change.edits) {
            if (last.edits.empty() || !absorbEdit(last.edits.back(), edit)) {
                last.edits.push_back(std::move(edit));
            }
        }
    }
    for (std::size_t i = 0; i < change.targets.size(); ++i) {
        last.targets[i].after = std::move(change.targets[i].after);
    }
    absorbSetting(last.constants, change.constants);
    absorbSetting(last.lights, change.lights);
    return true;
}

void SessionUndo::record(Change change) {
    std::erase_if(change.edits,
                  [](const HistoryEdit& edit) { return edit.before.empty() && edit.after.empty(); });
    if (comesToNothing(change)) {
        return;
    }
    m_redo.clear();
    if (absorb(change)) {
        if (comesToNothing(m_undo.back().change)) {
            m_undo.pop_back();
            finishStep();
        }
        return;
    }
    m_undo.push_back({std::move(change)});
}

void SessionUndo::finishStep() {
    if (canUndo()) {
        m_undo.back().finished = true;
    }
}

SessionUndo::Change SessionUndo::undo() {
    m_redo.push_back(std::move(m_undo.back()));
    m_undo.pop_back();
    return inverse(m_redo.back().change);
}

SessionUndo::Change SessionUndo::redo() {
    // Undone and made again, it is finished: a later change is a step of its own.
    m_undo.push_back({std::move(m_redo.back().change), true});
    m_redo.pop_back();
    return m_undo.back().change;
}

void SessionUndo::clear() {
    m_undo.clear();
    m_redo.clear();
}

}  // namespace hitscope
