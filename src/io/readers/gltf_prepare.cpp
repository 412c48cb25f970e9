// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/gltf_prepare.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <vector>

#include "io/readers/gltf_check.h"
#include "io/readers/gltf_extensions.h"
#include "io/readers/gltf_json.h"
#include "io/readers/gltf_numbers.h"
#include "io/readers/gltf_texture_transform.h"

namespace hitscope {
namespace {

QJsonObject rootOf(std::string_view json) {
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(
        QByteArray::fromRawData(json.data(), static_cast<qsizetype>(json.size())), &error);
    if (!document.isObject()) {
        throw BadGltf("its JSON is wrong at byte " + std::to_string(error.offset) + ": " +
                      error.errorString().toStdString());
    }
    return document.object();
}

/// Version 2 does not ask for one, Assimp does: all nodes that are in no other. Whether it was missing.
bool addScene(QJsonObject& root) {
    const QJsonArray nodes = root.value(QLatin1String("nodes")).toArray();
    if (!root.value(QLatin1String("scenes")).toArray().isEmpty() || nodes.isEmpty()) {
        return false;
    }
    std::vector<bool> isChild(static_cast<std::size_t>(nodes.size()), false);
    for (const QJsonValue& node : nodes) {
        for (const QJsonValue& child : node.toObject().value(QLatin1String("children")).toArray()) {
            if (const qint64 index = child.toInteger(-1); index >= 0 && index < nodes.size()) {
                isChild[static_cast<std::size_t>(index)] = true;
            }
        }
    }
    QJsonArray roots;
    for (std::size_t n = 0; n < isChild.size(); ++n) {
        if (!isChild[n]) {
            roots.append(static_cast<qint64>(n));
        }
    }
    root[QLatin1String("scenes")] = QJsonArray{QJsonObject{{QStringLiteral("nodes"), roots}}};
    root[QLatin1String("scene")] = 0;
    return true;
}

QStringList notesOnTextures(const QJsonObject& root) {
    const std::vector<MaterialTransform> materials = textureTransformsOf(root);
    const bool areMixed = std::any_of(materials.begin(), materials.end(),
                                      [](const MaterialTransform& material) { return material.isMixed; });
    return areMixed ? QStringList(QStringLiteral(
                          "Some textures may lie elsewhere than the file says: where those of a material are "
                          "moved in several ways (KHR_texture_transform), all are moved as the one that "
                          "colours it."))
                    : QStringList();
}

/// The file with another JSON.
std::string withJson(const QJsonObject& root, std::string_view file, const GltfParts& parts) {
    std::string json = QJsonDocument(root).toJson(QJsonDocument::Compact).toStdString();
    if (!file.starts_with("glTF")) {
        return json;
    }
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const auto put = [](std::string& bytes, std::size_t number) {
        const auto length = static_cast<std::uint32_t>(number);
        bytes.append(reinterpret_cast<const char*>(&length), sizeof length);
    };
    constexpr std::size_t kHeader = 20;
    std::string document(file.substr(0, 8));  // letters and version
    put(document, kHeader + json.size() + parts.rest.size());
    put(document, json.size());
    document.append("JSON").append(json).append(parts.rest);
    return document;
}

}  // namespace

Result<PreparedGltf> prepareGltf(std::string_view file, const QString& folder) {
    try {
        const GltfParts parts = gltfParts(file);
        QJsonObject root = rootOf(parts.json);
        PreparedGltf prepared;
        prepared.notes = checkGltfExtensions(root) + notesOnTextures(root);
        const bool hasNewScene = addScene(root);
        prepared.triangles = checkGltf(root, file.size(), folder).triangles;
        prepared.numbers = decodeGltf(root, parts.numbers, folder);
        if (hasNewScene || !prepared.numbers.empty()) {
            prepared.document = withJson(root, file, parts);
        }
        return prepared;
    } catch (const BadGltf& bad) {
        return Error{std::string(bad.what()), {}, bad.advice};
    }
}

}  // namespace hitscope
