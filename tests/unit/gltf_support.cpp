// SPDX-License-Identifier: GPL-3.0-or-later
#include "gltf_support.h"

#include "io_support.h"

namespace hitscope::test {
namespace {

void replace(QJsonObject& members, const QJsonObject& by) {
    for (auto it = by.begin(); it != by.end(); ++it) {
        members[it.key()] = it.value();
    }
}

void putPart(std::string& file, std::string content, const char* type, char padding) {
    content.resize((content.size() + 3) / 4 * 4, padding);
    put(file, static_cast<std::uint32_t>(content.size()));
    file.append(type, 4).append(content);
}

}  // namespace

int GltfFile::view(const std::string& bytes, int stride) {
    numbers.resize((numbers.size() + 3) / 4 * 4);
    QJsonObject view{{QStringLiteral("buffer"), 0},
                     {QStringLiteral("byteOffset"), static_cast<int>(numbers.size())},
                     {QStringLiteral("byteLength"), static_cast<int>(bytes.size())}};
    if (stride > 0) {
        view[QStringLiteral("byteStride")] = stride;
    }
    numbers += bytes;
    views.append(view);
    return static_cast<int>(views.size()) - 1;
}

int GltfFile::accessor(int view, int componentType, const char* type, int count, const QJsonObject& other) {
    QJsonObject accessor{{QStringLiteral("bufferView"), view},
                         {QStringLiteral("componentType"), componentType},
                         {QStringLiteral("type"), QString::fromLatin1(type)},
                         {QStringLiteral("count"), count}};
    replace(accessor, other);
    accessors.append(accessor);
    return static_cast<int>(accessors.size()) - 1;
}

QByteArray GltfFile::json(const QJsonObject& buffer) const {
    QJsonObject triangles{{QStringLiteral("attributes"), attributes}};
    replace(triangles, primitive);
    const QJsonObject mesh{{QStringLiteral("primitives"), QJsonArray{triangles}}};
    QJsonObject root{
        {QStringLiteral("asset"), QJsonObject{{QStringLiteral("version"), QStringLiteral("2.0")}}},
        {QStringLiteral("scene"), 0},
        {QStringLiteral("scenes"), QJsonArray{QJsonObject{{QStringLiteral("nodes"), QJsonArray{0}}}}},
        {QStringLiteral("nodes"), QJsonArray{QJsonObject{{QStringLiteral("mesh"), 0}}}},
        {QStringLiteral("meshes"), QJsonArray{mesh}},
        {QStringLiteral("accessors"), accessors},
        {QStringLiteral("bufferViews"), views},
        {QStringLiteral("buffers"), QJsonArray{buffer}}};
    replace(root, more);
    return QJsonDocument(root).toJson(QJsonDocument::Compact);
}

std::string GltfFile::text(const QString& uri) const {
    const QByteArray base64 = QByteArray::fromStdString(numbers).toBase64();
    const QString within = QStringLiteral("data:application/octet-stream;base64,") + QLatin1String(base64);
    return json({{QStringLiteral("byteLength"), static_cast<int>(numbers.size())},
                 {QStringLiteral("uri"), uri.isEmpty() ? within : uri}})
        .toStdString();
}

std::string GltfFile::glb() const {
    std::string parts;
    const QJsonObject buffer{{QStringLiteral("byteLength"), static_cast<int>(numbers.size())}};
    putPart(parts, json(buffer).toStdString(), "JSON", ' ');
    putPart(parts, numbers, "BIN\0", '\0');
    std::string file = "glTF";
    put(file, std::uint32_t{2}, static_cast<std::uint32_t>(parts.size() + 12));
    return file + parts;
}

std::string triangleCorners() {
    std::string bytes;
    put(bytes, 0.0f, 0.0f, 0.0f, 100.0f, 0.0f, 0.0f, 0.0f, 100.0f, 0.0f);
    return bytes;
}

GltfFile triangleFile() {
    GltfFile file;
    file.attributes[QStringLiteral("POSITION")] =
        file.accessor(file.view(triangleCorners()), kFloatNumbers, "VEC3", 3);
    return file;
}

}  // namespace hitscope::test
