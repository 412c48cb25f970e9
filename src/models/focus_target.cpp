// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/focus_target.h"

namespace hitscope {

const Target* focusTarget(const Session& session) {
    if (const Target* selected = session.target(session.selectedTarget())) {
        return selected;
    }
    if (!session.history().hits().empty()) {
        if (const Target* struck = session.target(session.history().hits().back().target)) {
            return struck;
        }
    }
    return session.targets().empty() ? nullptr : session.targets().front().get();
}

}  // namespace hitscope
