// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/mesh_data.h"

namespace hitscope::bench {

/// A picture of `size` x `size` pixels to put on targets: bricks in a rough colour, which go on seamlessly
/// over its edges, with detail down to the single pixel, so that no size is as good as a smaller one. size
/// >= 4.
[[nodiscard]] Image makeTexture(int size);

/// Gives all faces one material with a diffuse texture, image 0, which is left for someone else to bring: a
/// scene's targets share one.
void useTexture(MeshData& mesh);

/// A mesh without vertices that has the material of useTexture() and the image.
[[nodiscard]] MeshData textureCarrier(Image image);

}  // namespace hitscope::bench
