// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/focus_target.h"

namespace hitscope {

const Target* focusTarget(const Session& session) {
    if (const Target* selected = session.targets().find(session.targets().selected())) {
        return selected;
    }
    if (!session.hits().history().hits().empty()) {
        if (const Target* struck = session.targets().find(session.hits().history().hits().back().target)) {
            return struck;
        }
    }
    return session.targets().empty() ? nullptr : session.targets().front().get();
}

}  // namespace hitscope
