// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/imported_mesh.h"

struct aiScene;

namespace hitscope {

/// Converts a scene's materials, in its order, and decodes the pictures that the file itself holds.
void convertMaterials(const aiScene& scene, ImportedMesh& imported);

}  // namespace hitscope
