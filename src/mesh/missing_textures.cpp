// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/missing_textures.h"

#include <algorithm>
#include <utility>

namespace hitscope {

namespace {

/// A picture that was read and is not shown (heights, say) is not missing.
bool isMissing(const MeshData& mesh, const std::string& name, int image) {
    return !name.empty() && image < 0 &&
           std::find(mesh.pictureFiles.begin(), mesh.pictureFiles.end(), name) == mesh.pictureFiles.end();
}

}  // namespace

std::vector<std::string> missingTextures(const MeshData& mesh) {
    std::vector<std::string> names;
    const auto add = [&](const std::string& name, int image) {
        if (isMissing(mesh, name, image) && std::find(names.begin(), names.end(), name) == names.end()) {
            names.push_back(name);
        }
    };
    for (const Material& material : mesh.materials) {
        add(material.diffuseTexture, material.diffuseImage);
        add(material.normalMap.texture, material.normalMap.image);
        add(material.metalRoughness.texture, material.metalRoughness.image);
    }
    return names;
}

MeshData withTexture(MeshData mesh, const std::string& name, Image image) {
    const auto index = static_cast<int>(mesh.images.size());
    for (Material& material : mesh.materials) {
        if (material.diffuseTexture == name && material.diffuseImage < 0) {
            material.diffuseImage = index;
        }
        if (material.normalMap.texture == name && material.normalMap.image < 0) {
            material.normalMap.image = index;
        }
        if (material.metalRoughness.texture == name && material.metalRoughness.image < 0) {
            material.metalRoughness.image = index;
        }
    }
    mesh.images.push_back(std::move(image));
    return mesh;
}

}  // namespace hitscope
