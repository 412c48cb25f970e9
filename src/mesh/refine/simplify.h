// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/result.h"
#include "mesh/mesh_data.h"
#include "mesh/refine/mesh_region.h"
#include "mesh/refine/refine.h"

namespace hitscope {

struct SimplifyOptions {
    float share = 0.5f;  ///< of the triangles in the region that are to stay, (0, 1)
    MeshRegion region;

    bool operator==(const SimplifyOptions&) const = default;
};

/// Takes vertices away where that changes the shape least (Garland, Heckbert: Surface simplification using
/// quadric error metrics, 1997; OpenMesh's DecimaterT). Vertices that stay keep their order and positions,
/// and sourceVertices tells which they were. Faces that change become triangles. Borders, edges of three
/// faces, and what other faces share with the region stay; seams of texture coordinates and borders of
/// materials and groups stay where they are, with fewer vertices. So more faces may be left than asked for.
/// Errors: no usable share, given up.
[[nodiscard]] Result<MeshData> simplify(const MeshData& mesh, const SimplifyOptions& options,
                                        const MeshGoOn& goOn = {});

}  // namespace hitscope
