// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "view/cutting_plane.h"

class QSettings;

namespace hitscope {

/// How a cutting plane lies and what is drawn of it. Not whether it is on, nor where: a scene starts whole,
/// and the plane in its middle.
void loadCutSettings(const QSettings& settings, CuttingPlane& cut);
void saveCutSettings(QSettings& settings, const CuttingPlane& cut);

}  // namespace hitscope
