// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/session.h"

class QSettings;

namespace hitscope {

// The lights from one start to the next: places and attenuations relative to the scene, so that they fit
// another one too. What was never saved, or is out of range, stays as it is.
void loadLights(const QSettings& settings, Session& session);
void saveLights(QSettings& settings, const Session& session);

}  // namespace hitscope
