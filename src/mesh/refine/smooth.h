// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "mesh/mesh_data.h"
#include "mesh/refine/mesh_region.h"
#include "mesh/refine/refine.h"

namespace hitscope {

struct SmoothOptions {
    static constexpr int kMostPasses = 1000;
    int passes = 10;          ///< [1, kMostPasses]
    bool keepBorders = true;  ///< vertices of open edges stay; else they go along these
    /// Vertices are smoothed that it names, or that are in one of its balls.
    MeshRegion region;

    bool operator==(const SmoothOptions&) const = default;
};

/// Each pass moves a vertex half the way to the middle of those that its edges lead to (OpenMesh's
/// JacobiLaplaceSmootherT). Vertices at one place stay together; where OpenMesh cannot hold the faces around
/// one, as at edges of three faces, it stays. Numbers, faces and texture coordinates stay; normals go where
/// the surface moved. Errors: passes out of range, given up.
[[nodiscard]] Result<MeshData> smooth(const MeshData& mesh, const SmoothOptions& options,
                                      const MeshGoOn& goOn = {});

}  // namespace hitscope
