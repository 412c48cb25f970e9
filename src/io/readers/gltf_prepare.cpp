// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/gltf_prepare.h"

#include <QJsonDocument>
#include <QJsonObject>

#include "io/readers/gltf_check.h"
#include "io/readers/gltf_extensions.h"
#include "io/readers/gltf_json.h"
#include "io/readers/gltf_numbers.h"

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
        prepared.notes = checkGltfExtensions(root);
        prepared.triangles = checkGltf(root, file.size(), folder).triangles;
        prepared.numbers = decodeGltf(root, parts.numbers, folder);
        if (!prepared.numbers.empty()) {
            prepared.document = withJson(root, file, parts);
        }
        return prepared;
    } catch (const BadGltf& bad) {
        return Error{std::string(bad.what()), {}, bad.advice};
    }
}

}  // namespace hitscope
