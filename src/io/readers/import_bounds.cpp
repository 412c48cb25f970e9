// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/import_bounds.h"

namespace hitscope {

/// With a stack of its own: files can nest deeper than a thread's stack.
bool addUpParts(const std::vector<std::vector<std::size_t>>& parts, std::vector<NodeCounts>& counts) {
    enum class Mark : std::uint8_t { New, Open, Done };
    std::vector<Mark> marks(parts.size(), Mark::New);
    std::vector<std::size_t> open;
    for (std::size_t top = 0; top < parts.size(); ++top) {
        open.push_back(top);
        while (!open.empty()) {
            const std::size_t node = open.back();
            if (marks[node] == Mark::New) {
                marks[node] = Mark::Open;
                for (const std::size_t part : parts[node]) {
                    if (marks[part] == Mark::Open) {
                        return false;
                    }
                    if (marks[part] == Mark::New) {
                        open.push_back(part);
                    }
                }
                continue;
            }
            open.pop_back();
            if (marks[node] == Mark::Open) {
                for (const std::size_t part : parts[node]) {
                    counts[node].add(counts[part]);
                }
                marks[node] = Mark::Done;
            }
        }
    }
    return true;
}

}  // namespace hitscope
