// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/mesh_data.h"

namespace hitscope::bench {

inline constexpr float kSphereRadius = 2.5f;  ///< metres, the paper's

/// A sphere of about so many vertices: the paper's own where that is meant (7,938), else a UV sphere whose
/// quads are as square as they can be. vertices >= 8.
[[nodiscard]] MeshData makeSphere(int vertices);

}  // namespace hitscope::bench
