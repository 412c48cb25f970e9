// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/history_undo.h"

#include <utility>

namespace hitscope {

void HistoryUndo::recordAppend(std::size_t count) {
    m_redo.clear();
    Step step;
    step.appended = count;
    m_undo.push_back(std::move(step));
}

void HistoryUndo::recordChange(const HitHistory& history, const DeformationConstants& constants,
                               Merge merge) {
    m_redo.clear();
    if (merge == Merge::WithSameKind && canUndo() && m_undo.back().merge == merge) {
        return;
    }
    Step step;
    step.hits.assign(history.hits().begin(), history.hits().end());
    step.constants = constants;
    step.merge = merge;
    m_undo.push_back(std::move(step));
}

void HistoryUndo::swapWhole(Step& step, HitHistory& history, DeformationConstants& constants) {
    std::vector<Hit> now(history.hits().begin(), history.hits().end());
    history.assign(std::exchange(step.hits, std::move(now)));
    std::swap(step.constants, constants);
    // Undone and made again, it is finished: a later change is a step of its own.
    step.merge = Merge::Never;
}

DeformationConstants HistoryUndo::undo(HitHistory& history, const DeformationConstants& constants) {
    Step step = std::move(m_undo.back());
    m_undo.pop_back();
    DeformationConstants restored = constants;
    if (step.appended > 0) {
        const std::span<const Hit> last = history.hits().last(step.appended);
        step.hits.assign(last.begin(), last.end());
        for (std::size_t i = 0; i < step.appended; ++i) {
            history.removeLast();
        }
    } else {
        swapWhole(step, history, restored);
    }
    m_redo.push_back(std::move(step));
    return restored;
}

DeformationConstants HistoryUndo::redo(HitHistory& history, const DeformationConstants& constants) {
    Step step = std::move(m_redo.back());
    m_redo.pop_back();
    DeformationConstants restored = constants;
    if (step.appended > 0) {
        for (const Hit& hit : step.hits) {
            history.append(hit);
        }
        step.hits.clear();
    } else {
        swapWhole(step, history, restored);
    }
    m_undo.push_back(std::move(step));
    return restored;
}

void HistoryUndo::clear() {
    m_undo.clear();
    m_redo.clear();
}

}  // namespace hitscope
