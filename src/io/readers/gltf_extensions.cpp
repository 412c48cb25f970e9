// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/gltf_extensions.h"

#include <QJsonArray>
#include <algorithm>
#include <array>
#include <iterator>

#include "io/readers/gltf_json.h"

namespace hitscope {
namespace {

constexpr const char* kInstancing = "EXT_mesh_gpu_instancing";
constexpr const char* kTransform = "KHR_texture_transform";

constexpr std::array kPictureKinds{"KHR_texture_basisu", "EXT_texture_webp", "EXT_texture_avif",
                                   "MSFT_texture_dds"};

/// Besides materials and pictures: without them the surface is the same, or Assimp reads them (Draco's).
constexpr std::array kHarmless{"KHR_draco_mesh_compression",
                               "KHR_mesh_quantization",
                               kTransform,
                               "KHR_lights_punctual",
                               "KHR_binary_glTF",
                               "KHR_technique_webgl",
                               "KHR_techniques_webgl",
                               "KHR_animation_pointer",
                               "KHR_xmp",
                               "KHR_xmp_json_ld",
                               "EXT_lights_image_based",
                               "EXT_lights_ies",
                               "EXT_mesh_features",
                               "EXT_mesh_manifold",
                               "EXT_instance_features",
                               "EXT_structural_metadata",
                               "CESIUM_primitive_outline",
                               "MSFT_lod",
                               "MSFT_packing_normalRoughnessMetallic",
                               "MSFT_packing_occlusionRoughnessMetallic"};

template <std::size_t N>
bool isOneOf(const std::array<const char*, N>& names, const QString& name) {
    return std::any_of(names.begin(), names.end(),
                       [&name](const char* each) { return name == QLatin1String(each); });
}

bool isKnown(const QString& name) {
    return isOneOf(kHarmless, name) || isOneOf(kPictureKinds, name) ||
           name.contains(QLatin1String("_materials_"));
}

QStringList namesIn(const QJsonObject& root, const char* list) {
    QStringList names;
    for (const QJsonValue& name : root.value(QLatin1String(list)).toArray()) {
        names << name.toString();
    }
    return names;
}

QJsonObject extensionsOf(const QJsonValue& thing) {
    return thing.toObject().value(QLatin1String("extensions")).toObject();
}

/// Of pictures that a texture has in one of the other kinds alone.
QStringList picturesOfOtherKinds(const QJsonObject& root) {
    QStringList kinds;
    for (const QJsonValue& texture : root.value(QLatin1String("textures")).toArray()) {
        for (const QString& name : extensionsOf(texture).keys()) {
            const bool isAlone = !texture.toObject().contains(QLatin1String("source"));
            if (isAlone && isOneOf(kPictureKinds, name) && !kinds.contains(name)) {
                kinds << name;
            }
        }
    }
    return kinds;
}

}  // namespace

QStringList checkGltfExtensions(const QJsonObject& root) {
    QStringList unknown;
    const QStringList required = namesIn(root, "extensionsRequired");
    std::copy_if(required.begin(), required.end(), std::back_inserter(unknown),
                 [](const QString& name) { return !isKnown(name); });
    if (!unknown.isEmpty()) {
        const std::string names = unknown.join(QStringLiteral(", ")).toStdString();
        const bool isOne = unknown.size() == 1;
        throw BadGltf((isOne ? "it needs the extension " : "it needs the extensions ") + names +
                          ", which Hitscope cannot read",
                      isOne ? "Export it without that extension from the program it came from."
                            : "Export it without these extensions from the program it came from.");
    }
    QStringList notes;
    const QJsonArray nodes = root.value(QLatin1String("nodes")).toArray();
    const auto instanced = std::count_if(nodes.begin(), nodes.end(), [](const QJsonValue& node) {
        return extensionsOf(node).contains(QLatin1String(kInstancing));
    });
    if (instanced > 0) {
        notes << QStringLiteral("Of instances that lie in numbers (%1) only the mesh itself was read.")
                     .arg(QLatin1String(kInstancing));
    }
    for (const QString& kind : picturesOfOtherKinds(root)) {
        notes << QStringLiteral("Textures of a kind that cannot be read (%1) are not shown.").arg(kind);
    }
    return notes;
}

}  // namespace hitscope
