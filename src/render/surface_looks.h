// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/material_set.h"
#include "view/display_options.h"

namespace hitscope::render {

/// The material that all surfaces have in this look; null: each its own.
[[nodiscard]] const MaterialSet* materialOfLook(SurfaceLook look);

}  // namespace hitscope::render
