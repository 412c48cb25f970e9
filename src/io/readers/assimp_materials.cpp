// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/assimp_materials.h"

#include <assimp/GltfMaterial.h>
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

NormalMap normalMapOf(const aiMaterial& from) {
    NormalMap map;
    aiString path;
    for (const aiTextureType type : {aiTextureType_NORMALS, aiTextureType_NORMAL_CAMERA}) {
        if (from.GetTexture(type, 0, &path) == aiReturn_SUCCESS) {
            map.texture = path.C_Str();
            float scale = 1.0f;  // glTF's
            if (from.Get(AI_MATKEY_GLTF_TEXTURE_SCALE(type, 0), scale) == aiReturn_SUCCESS &&
                std::isfinite(scale)) {
                map.strength = scale;
            }
            break;
        }
    }
    return map;
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
    material.normalMap = normalMapOf(from);
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

/// Embedded pictures have no file: who refers to one keeps no path, only the image.
class EmbeddedPictures {
public:
    EmbeddedPictures(const aiScene& scene, ImportedMesh& imported) : m_scene(scene), m_imported(imported) {}

    void take(const Material& material, const char* what, std::string& path, int& image) {
        const aiTexture* const texture = path.empty() ? nullptr : m_scene.GetEmbeddedTexture(path.c_str());
        if (!texture || !texture->pcData) {
            return;
        }
        const auto [at, isNew] = m_known.try_emplace(texture, -1);
        if (isNew) {
            QString why;
            if (std::optional<Image> converted = convertTexture(*texture, why)) {
                at->second = static_cast<int>(m_imported.mesh.images.size());
                m_imported.mesh.images.push_back(std::move(*converted));
            } else {
                m_imported.notes += QStringLiteral("The %1 of the material \"%2\" is not shown: %3.")
                                        .arg(QLatin1String(what), QString::fromStdString(material.name), why);
            }
        }
        image = at->second;
        path.clear();
    }

private:
    const aiScene& m_scene;
    ImportedMesh& m_imported;
    std::unordered_map<const aiTexture*, int> m_known;
};

}  // namespace

void convertMaterials(const aiScene& scene, ImportedMesh& imported) {
    for (unsigned m = 0; m < scene.mNumMaterials; ++m) {
        imported.mesh.materials.push_back(convertMaterial(*scene.mMaterials[m]));
    }
    EmbeddedPictures pictures(scene, imported);
    for (Material& material : imported.mesh.materials) {
        pictures.take(material, "texture", material.diffuseTexture, material.diffuseImage);
        pictures.take(material, "normal map", material.normalMap.texture, material.normalMap.image);
    }
}

}  // namespace hitscope
