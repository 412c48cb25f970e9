// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/result.h"
#include "mesh/mesh_data.h"

namespace hitscope {

enum class UpAxis : std::uint8_t { Y, Z };

/// Other units or another axis that points up.
struct CoordinateChange {
    double scale = 1.0;  ///< of all lengths, about the file's origin; above 0
    UpAxis from = UpAxis::Y;
    UpAxis to = UpAxis::Y;  ///< turned about the x axis, so that x stays
};

/// Gives the mesh other coordinates in its file; the placement follows, so that local positions are scaled
/// and turned alike. Errors: a coordinate would not be finite, or be no float.
[[nodiscard]] Status changeCoordinates(MeshData& mesh, const CoordinateChange& change);

}  // namespace hitscope
