// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/mesh_data.h"

namespace hitscope {

/// The Utah teapot, evaluated from Newell's published bicubic Bezier patches: y up, standing on y = 0,
/// about 6.4 x 3.2 x 4 metres, each patch `divisions` x `divisions` quads (triangles where a patch edge
/// collapses to a point). Vertices on shared patch edges are welded; texture coordinates follow (u, v) of
/// each patch; smooth normals from the patches' own derivatives. The
/// pot, the lid, the handle and the spout are four surfaces, open where they meet, as in the published data.
/// divisions >= 1; with 1 the handle and the spout are flat.
[[nodiscard]] MeshData makeTeapot(int divisions = 16);

}  // namespace hitscope
