// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "mesh/mesh_data.h"
#include "mesh/render_mesh.h"
#include "mesh/true_normals.h"
#include "physics/collision_mesh.h"

namespace hitscope {

/// A mesh with everything derived from it that does not change, made once and shared by the targets that have
/// this shape. Making it takes seconds for millions of triangles, so it may be done on any thread.
struct PreparedMesh {
    std::shared_ptr<const MeshData> mesh;
    std::shared_ptr<const RenderMesh> render;
    std::shared_ptr<const TrueNormals> trueNormals;  ///< at the original shape
    std::shared_ptr<const CollisionMesh> collision;  ///< the render mesh's triangles
};

/// `mesh` has passed validate().
[[nodiscard]] PreparedMesh prepareMesh(MeshData mesh);

}  // namespace hitscope
