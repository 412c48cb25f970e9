// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/history_prefix.h"

#include <algorithm>

namespace hitscope {

std::vector<HistoryEdit> HistoryPrefix::follow(std::span<const HistoryEdit> edits,
                                               std::span<const Hit> history, std::size_t wanted) {
    std::vector<HistoryEdit> made;
    for (const HistoryEdit& edit : edits) {
        if (edit.first >= m_size) {
            continue;  // behind the last of them
        }
        // Of an edit that reaches beyond the last, all that it brings is taken in: it is the end then.
        const std::size_t taken = std::min(edit.before.size(), m_size - edit.first);
        made.push_back({edit.first,
                        {edit.before.begin(), edit.before.begin() + static_cast<std::ptrdiff_t>(taken)},
                        edit.after});
        m_size = m_size - taken + edit.after.size();
    }
    const auto hits = [history](std::size_t first, std::size_t end) {
        const std::span<const Hit> some = history.subspan(first, end - first);
        return std::vector<Hit>(some.begin(), some.end());
    };
    if (m_size < wanted) {
        made.push_back({m_size, {}, hits(m_size, wanted)});
    } else if (m_size > wanted) {
        made.push_back({wanted, hits(wanted, m_size), {}});
    }
    m_size = wanted;
    return made;
}

}  // namespace hitscope
