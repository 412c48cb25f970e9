// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/welcome.h"

#include <glm/geometric.hpp>

#include "session/session.h"

namespace hitscope {

void loadWelcomeScene(Session& session) {
    loadTeapot(session);
    const Bounds bounds = session.targets().bounds();
    // From beside the eye of the first view, so that light and shade show the dent's depth.
    const glm::vec3 towards = glm::normalize(glm::vec3(-0.35f, -0.15f, -0.9f));
    session.simulation().hitscan({bounds.centre() - bounds.diagonal() * towards, towards});
}

}  // namespace hitscope
