// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/mesh_data.h"

namespace hitscope {

/// Geodesic sphere about the origin: an icosahedron whose triangles are each cut into frequency^2 and pushed
/// out onto the sphere of `radius` metres, so that triangles are nearly alike everywhere. 10 * frequency^2 +
/// 2 vertices, 20 * frequency^2 triangles; smooth unit normals; texture coordinates as on a globe, with a
/// seam. An "ico sphere" of k subdivisions has frequency 2^k. frequency >= 1.
[[nodiscard]] MeshData makeGeodesicSphere(int frequency, float radius);

}  // namespace hitscope
