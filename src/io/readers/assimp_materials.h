// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "io/imported_mesh.h"

struct aiScene;

namespace hitscope {

/// Converts a scene's materials, in its order but for those that Assimp adds, and decodes the pictures that
/// the file itself holds.
void convertMaterials(const aiScene& scene, ImportedMesh& imported);

/// Gives textures, which glTF names by URIs, the names of their files in `folder`, where only those are
/// found.
void nameTexturesOfUris(const QString& folder, MeshData& mesh);

}  // namespace hitscope
