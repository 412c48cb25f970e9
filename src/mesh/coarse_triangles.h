// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "mesh/render_mesh.h"

namespace hitscope {

/// So many triangles have about half as many vertices, which a software renderer transforms in some
/// five milliseconds.
inline constexpr std::size_t kCoarseTriangles = 32'768;

/// Fills `coarseTriangles`, `coarseDraws` and `coarseRuns`: about `wanted` triangles in place of all, of
/// which each draw has its share; leaves them empty where there are less than twice as many. They are spread
/// evenly whatever the shape is, since hits may dent a flat place. By meshoptimizer's
/// meshopt_simplifySloppy(), which puts one vertex in place of all in a cell of a grid. Changes nothing else:
/// other threads may read the rest.
void addCoarseTriangles(RenderMesh& mesh, std::size_t wanted = kCoarseTriangles);

}  // namespace hitscope
