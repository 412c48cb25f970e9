// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "view/display_options.h"

class QSettings;

namespace hitscope {

/// What is remembered of colour maps of change and of before and after: all but whether the map, exaggeration
/// and wipe are on, so that a new start shows the mesh as it is. What was never saved or makes no sense stays
/// as it was.
void loadChangeSettings(const QSettings& settings, DisplayOptions& display);
void saveChangeSettings(QSettings& settings, const DisplayOptions& display);

}  // namespace hitscope
