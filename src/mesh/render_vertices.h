// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/corner_normals.h"
#include "mesh/render_mesh.h"

namespace hitscope {

/// The first step of buildRenderMesh(): fills vertices, drawnVertices, texcoords, fileVertices,
/// cornerRenderVertices, clusters, their boxes, and bounds.
void makeRenderVertices(const MeshData& mesh, const VertexCorners& vertexCorners,
                        const CornerNormals& normals, RenderMesh& render);

}  // namespace hitscope
