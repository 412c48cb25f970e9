// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/history_edits.h"

#include <utility>

namespace hitscope {

std::vector<HistoryEdit> withAppendsJoined(std::vector<HistoryEdit> edits) {
    std::vector<HistoryEdit> joined;
    for (HistoryEdit& edit : edits) {
        HistoryEdit* last = joined.empty() ? nullptr : &joined.back();
        if (last != nullptr && last->before.empty() && edit.before.empty() &&
            last->first + last->after.size() == edit.first) {
            last->after.insert(last->after.end(), edit.after.begin(), edit.after.end());
        } else {
            joined.push_back(std::move(edit));
        }
    }
    return joined;
}

bool isAppend(const HistoryEdit& edit, std::size_t hits) {
    return edit.before.empty() && edit.first + edit.after.size() == hits;
}

std::vector<HistoryEdit> withoutUndone(std::vector<HistoryEdit> edits) {
    std::vector<HistoryEdit> left;
    for (HistoryEdit& edit : edits) {
        const bool isInPlace = edit.before.size() == edit.after.size();
        if (isInPlace && !left.empty() && left.back().first == edit.first &&
            left.back().before == edit.after && left.back().after == edit.before) {
            left.pop_back();
        } else {
            left.push_back(std::move(edit));
        }
    }
    return left;
}

}  // namespace hitscope
