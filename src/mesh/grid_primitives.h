// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/mesh_data.h"

namespace hitscope {

/// Torus about the y axis, its middle at the origin: around * tube vertices and quads; smooth unit normals;
/// texture coordinates with a seam each way. `radius` (metres) reaches to the middle of the tube, whose own
/// radius is `tubeRadius` < radius. around, tube >= 3.
[[nodiscard]] MeshData makeTorus(int around, int tube, float radius, float tubeRadius);

/// Closed cylinder about the y axis, its middle at the origin: sides of around * up quads, each end of
/// `rings` rings of quads and a fan of triangles in the middle, so that all of it dents. around * (up + 1 + 2
/// * (rings - 1)) + 2 vertices; hard edges between side and ends. around >= 3, up >= 1, rings >= 1. Metres.
[[nodiscard]] MeshData makeCylinder(int around, int up, int rings, float radius, float height);

/// Upright flat sheet through the origin, facing +z: columns x rows quads, (columns + 1) * (rows + 1)
/// vertices; texture coordinates [0, 1]^2. columns, rows >= 1. Metres.
[[nodiscard]] MeshData makeSheet(int columns, int rows, float width, float height);

}  // namespace hitscope
