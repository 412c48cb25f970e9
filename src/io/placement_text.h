// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "mesh/mesh_data.h"

namespace hitscope {

/// How the scene's coordinates come from those of the mesh's file:
/// "In the scene it is moved by (-500000, -4500000, 0) then scaled by 0.5." The numbers read back as the
/// same.
[[nodiscard]] QString placementText(const Placement& placement);

}  // namespace hitscope
