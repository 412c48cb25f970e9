// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/texture.h"

#include <utility>

namespace hitscope::bench {

namespace {

Material texturedMaterial() {
    Material material;
    material.name = "panels";
    material.diffuse = glm::vec3(1.0f);
    material.diffuseTexture = "panels";
    material.diffuseImage = 0;
    return material;
}

}  // namespace

void useTexture(MeshData& mesh) {
    mesh.materials = {texturedMaterial()};
    mesh.materials.front().diffuseImage = -1;
    mesh.faceMaterials.assign(mesh.faceCount(), 0);
}

MeshData textureCarrier(Image image) {
    MeshData mesh;
    mesh.materials = {texturedMaterial()};
    mesh.images.push_back(std::move(image));
    return mesh;
}

}  // namespace hitscope::bench
