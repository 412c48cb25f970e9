// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/gltf_texture_transform.h"

#include <QJsonArray>
#include <algorithm>
#include <cmath>

namespace hitscope {
namespace {

QJsonObject objectIn(const QJsonObject& object, const char* key) {
    return object.value(QLatin1String(key)).toObject();
}

glm::dvec2 pairIn(const QJsonObject& object, const char* key, double otherwise) {
    const QJsonArray pair = object.value(QLatin1String(key)).toArray();
    return {pair.at(0).toDouble(otherwise), pair.at(1).toDouble(otherwise)};
}

/// `texture`: what refers to one.
TextureTransform transformOf(const QJsonObject& texture) {
    const QJsonObject given = objectIn(objectIn(texture, "extensions"), "KHR_texture_transform");
    return {pairIn(given, "scale", 1.0), given.value(QLatin1String("rotation")).toDouble(),
            pairIn(given, "offset", 0.0)};
}

/// All that a part of a material refers to, at any depth.
void addTextures(const QJsonObject& part, std::vector<QJsonObject>& textures) {
    for (auto it = part.begin(); it != part.end(); ++it) {
        const QJsonObject inside = it.value().toObject();
        if (it.key().endsWith(QLatin1String("Texture"))) {
            textures.push_back(inside);
        } else {
            addTextures(inside, textures);
        }
    }
}

MaterialTransform transformsOf(const QJsonObject& material) {
    std::vector<QJsonObject> textures;
    addTextures(material, textures);
    if (textures.empty()) {
        return {};
    }
    const QJsonObject older =
        objectIn(objectIn(material, "extensions"), "KHR_materials_pbrSpecularGlossiness");
    QJsonObject colours = objectIn(objectIn(material, "pbrMetallicRoughness"), "baseColorTexture");
    colours = colours.isEmpty() ? objectIn(older, "diffuseTexture") : colours;
    MaterialTransform made;
    made.main = transformOf(colours.isEmpty() ? textures.front() : colours);
    made.isMixed = std::any_of(textures.begin(), textures.end(), [&made](const QJsonObject& texture) {
        return !(transformOf(texture) == made.main);
    });
    return made;
}

}  // namespace

glm::vec2 TextureTransform::apply(const glm::vec2& texcoord) const {
    const glm::dvec2 scaled = scale * glm::dvec2(texcoord);
    const double cosine = std::cos(rotation);
    const double sine = std::sin(rotation);
    return glm::dvec2(cosine * scaled.x + sine * scaled.y, cosine * scaled.y - sine * scaled.x) + offset;
}

std::vector<MaterialTransform> textureTransformsOf(const QJsonObject& root) {
    std::vector<MaterialTransform> transforms;
    for (const QJsonValue& material : root.value(QLatin1String("materials")).toArray()) {
        transforms.push_back(transformsOf(material.toObject()));
    }
    return transforms;
}

}  // namespace hitscope
