// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hitscope {

class Session;

/// What the window opens on: the Utah teapot with one dent in its side, where the first view looks.
void loadWelcomeScene(Session& session);

}  // namespace hitscope
