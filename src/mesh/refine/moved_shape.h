// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "mesh/mesh_data.h"

namespace hitscope {

/// The mesh with other positions as its own; vertices that stay keep theirs in every bit. Normals of faces
/// with a vertex that moves are those of another surface: they go, and are computed when it is drawn.
/// `positions`: one a vertex, finite, metres, local frame.
[[nodiscard]] MeshData withShape(MeshData mesh, std::span<const glm::vec3> positions);

}  // namespace hitscope
