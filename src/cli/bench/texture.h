// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/mesh_data.h"

namespace hitscope::bench {

/// Gives all faces one material with a diffuse texture, image 0, which is left for someone else to bring: a
/// scene's targets share one.
void useTexture(MeshData& mesh);

/// A mesh without vertices that has the material of useTexture() and the image.
[[nodiscard]] MeshData textureCarrier(Image image);

}  // namespace hitscope::bench
