// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/assimp_materials.h"

#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "io/readers/textures.h"

namespace hitscope {
namespace {

bool isFraction(float value) {
    return std::isfinite(value) && value >= 0.0f && value <= 1.0f;
}

void readColour(const aiMaterial& from, const char* key, unsigned type, unsigned index, glm::vec3& colour) {
    aiColor4D value;
    if (aiGetMaterialColor(&from, key, type, index, &value) == aiReturn_SUCCESS && isFraction(value.r) &&
        isFraction(value.g) && isFraction(value.b)) {
        colour = {value.r, value.g, value.b};
    }
}

std::string texturePath(const aiMaterial& from) {
    aiString path;
    for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
        if (from.GetTexture(type, 0, &path) == aiReturn_SUCCESS) {
            return path.C_Str();
        }
    }
    return {};
}

Material convertMaterial(const aiMaterial& from) {
    Material material;
    aiString name;
    if (from.Get(AI_MATKEY_NAME, name) == aiReturn_SUCCESS) {
        material.name = name.C_Str();
    }
    readColour(from, AI_MATKEY_COLOR_AMBIENT, material.ambient);
    readColour(from, AI_MATKEY_COLOR_DIFFUSE, material.diffuse);
    readColour(from, AI_MATKEY_BASE_COLOR, material.diffuse);
    readColour(from, AI_MATKEY_COLOR_SPECULAR, material.specular);
    float value = 0.0f;
    if (from.Get(AI_MATKEY_SHININESS, value) == aiReturn_SUCCESS && std::isfinite(value) && value > 0.0f) {
        material.shininess = value;
    }
    if (from.Get(AI_MATKEY_OPACITY, value) == aiReturn_SUCCESS && isFraction(value)) {
        material.opacity = value;
    }
    material.diffuseTexture = texturePath(from);
    return material;
}

/// Compressed pictures are a file in memory (height 0, width its size in bytes); others are texels.
std::optional<Image> convertTexture(const aiTexture& texture, QString& why) {
    if (texture.mHeight == 0) {
        return decodeImage(
            QByteArray(reinterpret_cast<const char*>(texture.pcData), static_cast<qsizetype>(texture.mWidth)),
            why);
    }
    constexpr unsigned kMaxSide = 8192;
    if (texture.mWidth > kMaxSide || texture.mHeight > kMaxSide) {
        why = QStringLiteral("it is larger than 8192 x 8192 pixels");
        return std::nullopt;
    }
    Image image{static_cast<int>(texture.mWidth), static_cast<int>(texture.mHeight), {}};
    const std::size_t texels = std::size_t{texture.mWidth} * texture.mHeight;
    image.pixels.reserve(4 * texels);
    for (std::size_t i = 0; i < texels; ++i) {
        const aiTexel& texel = texture.pcData[i];
        image.pixels.insert(image.pixels.end(), {texel.r, texel.g, texel.b, texel.a});
    }
    return image;
}

/// Embedded pictures have no file: their material keeps no path, only the image.
void takeEmbedded(const aiScene& scene, ImportedMesh& imported) {
    std::unordered_map<const aiTexture*, int> known;
    for (Material& material : imported.mesh.materials) {
        const aiTexture* const texture = material.diffuseTexture.empty()
                                             ? nullptr
                                             : scene.GetEmbeddedTexture(material.diffuseTexture.c_str());
        if (!texture || !texture->pcData) {
            continue;
        }
        const auto [at, isNew] = known.try_emplace(texture, -1);
        if (isNew) {
            QString why;
            if (std::optional<Image> image = convertTexture(*texture, why)) {
                at->second = static_cast<int>(imported.mesh.images.size());
                imported.mesh.images.push_back(std::move(*image));
            } else {
                imported.notes += QStringLiteral("The texture of the material \"%1\" is not shown: %2.")
                                      .arg(QString::fromStdString(material.name), why);
            }
        }
        material.diffuseImage = at->second;
        material.diffuseTexture.clear();
    }
}

}  // namespace

void convertMaterials(const aiScene& scene, ImportedMesh& imported) {
    for (unsigned m = 0; m < scene.mNumMaterials; ++m) {
        imported.mesh.materials.push_back(convertMaterial(*scene.mMaterials[m]));
    }
    takeEmbedded(scene, imported);
}

}  // namespace hitscope
