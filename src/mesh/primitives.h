// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "mesh/mesh_data.h"

namespace hitscope {

/// Cube of half extent `halfExtent` metres about the origin, each face `segments` x `segments` quads that
/// share their vertices along the edges: 6 * segments^2 + 2 vertices. One normal a face (hard edges), texture
/// coordinates [0, 1]^2 on each face. segments >= 1.
[[nodiscard]] MeshData makeCube(int segments, float halfExtent);

/// UV sphere about the origin, poles on y: segments * (rings - 1) + 2 vertices, triangles at the poles and
/// quads elsewhere; smooth unit normals; texture coordinates with a seam. segments >= 3, rings >= 2.
[[nodiscard]] MeshData makeUvSphere(int segments, int rings, float radius);

/// The mesh with every polygon split into quads as Catmull-Clark does (face point, edge points; no
/// smoothing), every vertex then projected onto the sphere of `radius` about the origin. Normals are
/// recomputed as radial.
[[nodiscard]] MeshData splitIntoQuadsOnSphere(const MeshData& sphere, float radius);

/// The paper's four meshes (section 3): 386, 6,146, 382 and 7,938 vertices. halfExtent / radius in metres.
[[nodiscard]] MeshData makeLowPolyCube(float halfExtent = 2.5f);
[[nodiscard]] MeshData makeHighPolyCube(float halfExtent = 2.5f);
[[nodiscard]] MeshData makeLowPolySphere(float radius = 2.5f);
[[nodiscard]] MeshData makeHighPolySphere(float radius = 2.5f);

}  // namespace hitscope
