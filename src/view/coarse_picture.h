// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image.h"
#include "mesh/mesh_data.h"
#include "view/camera.h"

namespace hitscope {

/// A quick picture of a mesh for the time until it can be drawn: each face in one shade of its material's
/// colour, without textures, smoothing or shadows; transparent around it. `light`: the way light travels,
/// world, any length > 0. Drawn by the CPU on all
/// processors, on any thread, and the same whatever their number. `mesh` has passed validate(); width and
/// height are pixels, > 0. Faces that reach behind the eye are left out.
[[nodiscard]] Image drawCoarsely(const MeshData& mesh, const Camera& camera, const glm::vec3& light,
                                 int width, int height);

}  // namespace hitscope
