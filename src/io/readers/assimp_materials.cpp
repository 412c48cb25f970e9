// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/assimp_materials.h"

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_map>

#include "io/file_scope.h"
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

/// glTF's; empty: of another format.
std::string alphaModeOf(const aiMaterial& from) {
    aiString mode;
    return from.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) == aiReturn_SUCCESS ? mode.C_Str() : std::string();
}

/// Which way it is described, where a file does so in both.
bool hasGlossiness(const aiMaterial& from) {
    float glossiness = 0.0f;
    return from.Get(AI_MATKEY_GLOSSINESS_FACTOR, glossiness) == aiReturn_SUCCESS;
}

bool isUnlit(const aiMaterial& from) {
    int model = 0;
    return from.Get(AI_MATKEY_SHADING_MODEL, model) == aiReturn_SUCCESS && model == aiShadingMode_NoShading;
}

/// Only glTF's: what Assimp makes of other formats' shininess is no roughness.
MetalRoughness metalRoughnessOf(const aiMaterial& from) {
    MetalRoughness metal;
    if (alphaModeOf(from).empty() || hasGlossiness(from) || isUnlit(from)) {
        return metal;
    }
    float metalness = 0.0f;
    float roughness = 0.0f;
    if (from.Get(AI_MATKEY_METALLIC_FACTOR, metalness) != aiReturn_SUCCESS || !isFraction(metalness) ||
        from.Get(AI_MATKEY_ROUGHNESS_FACTOR, roughness) != aiReturn_SUCCESS || !isFraction(roughness)) {
        return metal;
    }
    metal.metalness = metalness;
    metal.roughness = roughness;
    aiString path;
    if (from.GetTexture(AI_MATKEY_GLTF_PBRMETALLICROUGHNESS_METALLICROUGHNESS_TEXTURE, &path) ==
            aiReturn_SUCCESS ||
        from.GetTexture(AI_MATKEY_METALLIC_TEXTURE, &path) == aiReturn_SUCCESS) {
        metal.texture = path.C_Str();
    }
    return metal;
}

float opacityOf(const aiMaterial& from) {
    if (const std::string mode = alphaModeOf(from); !mode.empty() && mode != "BLEND") {
        return 1.0f;  // the factor is not to be looked at
    }
    float opacity = 1.0f;
    return from.Get(AI_MATKEY_OPACITY, opacity) == aiReturn_SUCCESS && isFraction(opacity) ? opacity : 1.0f;
}

Material convertMaterial(const aiMaterial& from) {
    Material material;
    aiString name;
    if (from.Get(AI_MATKEY_NAME, name) == aiReturn_SUCCESS) {
        material.name = name.C_Str();
    }
    readColour(from, AI_MATKEY_COLOR_AMBIENT, material.ambient);
    readColour(from, AI_MATKEY_COLOR_DIFFUSE, material.diffuse);
    if (!hasGlossiness(from)) {
        readColour(from, AI_MATKEY_BASE_COLOR, material.diffuse);
    }
    readColour(from, AI_MATKEY_COLOR_SPECULAR, material.specular);
    float value = 0.0f;
    if (from.Get(AI_MATKEY_SHININESS, value) == aiReturn_SUCCESS && std::isfinite(value) && value > 0.0f) {
        material.shininess = value;
    }
    material.opacity = opacityOf(from);
    if (isUnlit(from)) {
        material.specular = glm::vec3(0.0f);
    }
    material.diffuseTexture = texturePath(from);
    material.normalMap = normalMapOf(from);
    material.metalRoughness = metalRoughnessOf(from);
    return material;
}

bool isNameless(const Material& material) {
    return material.name.empty() || material.name == AI_DEFAULT_MATERIAL_NAME;
}

bool isPlain(const Material& material) {
    const bool isGrey = material.diffuse.x == material.diffuse.y && material.diffuse.y == material.diffuse.z;
    return isGrey && material.opacity == 1.0f && material.diffuseTexture.empty() &&
           material.normalMap.texture.empty() && material.metalRoughness.texture.empty();
}

/// Assimp's own, for parts that have no material. In a glTF file it is the format's default, without a name.
bool isAdded(const Material& material) {
    const bool isDefault = material.diffuse == glm::vec3(1.0f) && material.metalRoughness.metalness == 1.0f &&
                           material.metalRoughness.roughness == 1.0f;
    return isPlain(material) && isNameless(material) && (isDefault || !material.name.empty());
}

/// Faces that had none have none again. Two in a glTF file of ours: the one that GltfMaterials writes for
/// programs to which the format's default is a dark metal, and Assimp's, which it adds always.
void dropAdded(ImportedMesh& imported) {
    MeshData& mesh = imported.mesh;
    while (!mesh.materials.empty() && isAdded(mesh.materials.back())) {
        mesh.materials.pop_back();
        const std::size_t last = mesh.materials.size();
        std::erase(imported.opaqueMaterials, last);
        std::replace(mesh.faceMaterials.begin(), mesh.faceMaterials.end(), static_cast<std::uint32_t>(last),
                     kNoIndex);
    }
    if (mesh.materials.empty()) {
        mesh.faceMaterials.clear();
    }
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
        if (alphaModeOf(*scene.mMaterials[m]) == "OPAQUE") {
            imported.opaqueMaterials.push_back(m);
        }
    }
    dropAdded(imported);
    EmbeddedPictures pictures(scene, imported);
    for (Material& material : imported.mesh.materials) {
        pictures.take(material, "texture", material.diffuseTexture, material.diffuseImage);
        pictures.take(material, "normal map", material.normalMap.texture, material.normalMap.image);
        MetalRoughness& metal = material.metalRoughness;
        pictures.take(material, "map of metalness and roughness", metal.texture, metal.image);
    }
}

void nameTexturesOfUris(const QString& folder, MeshData& mesh) {
    const auto rename = [&folder](std::string& texture) {
        const QString uri = fileNameText(texture);
        if (const QString name = textureOfUri(folder, uri); name != uri) {
            texture = name.toStdString();
        }
    };
    for (Material& material : mesh.materials) {
        rename(material.diffuseTexture);
        rename(material.normalMap.texture);
        rename(material.metalRoughness.texture);
    }
}

}  // namespace hitscope
